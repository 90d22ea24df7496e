// SPDX-License-Identifier: BSD-3-Clause
// Promises: in a placement scene with several arms, those that rest are obstacles to the one that moves, to
// the planner and to the verification alike; each arm can be the one that places; what contradicts itself is
// refused in one line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>

#include <random>
#include <set>

#include "experiments/fixtures.h"
#include "experiments/placement/placement_check.h"
#include "experiments/placement/placement_file.h"
#include "experiments/placement/placement_problem.h"
#include "experiments/placement/placement_query.h"
#include "experiments/verification/placement_verifier.h"
#include "robots/input_error.h"

namespace b4p::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Configuration = std::vector<double>;

constexpr const char* kScene = "placement/yumi_table_cluttered_small_crayons";
constexpr std::size_t kLeft = 0, kRight = 1;

Scene withStart(Scene scene, std::size_t arm, const Configuration& start) {
  scene.placing().arms[arm].start = start;
  return scene;
}

/// What stops an arm on the straight way from its start, in a few words. Empty: nothing does.
struct Obstruction {
  std::string for_planner, for_verifier;
};

/// @param q  where the way ends
Obstruction onTheWay(const Scene& scene, std::size_t arm, const Configuration& q) {
  Obstruction found;
  const ScenePlacementWorld world(scene);
  const ScenePlacementWorld::Arm& moving = world.arms()[arm];
  const Configuration& start = scene.placing().arms[arm].start;
  const auto motions = world.motions()->makeContext();
  const auto context = moving.checker->makeContext();
  const double fraction = motions->freeFraction(start.data(), q.data(), static_cast<GraspId>(arm));
  constexpr int kSteps = 100;  // in search of a configuration that says what with
  for (int step = 0; fraction < 1.0 && found.for_planner.empty() && step <= kSteps; ++step) {
    Configuration hit = q;
    for (std::size_t i = 0; i < q.size(); ++i) hit[i] = start[i] + (q[i] - start[i]) * step / kSteps;
    found.for_planner = context->describeCollision(hit.data(), &moving.grasp);
  }
  PlacementImprovement improvement;
  improvement.arm = static_cast<int>(arm);
  improvement.path = {start, q};
  const std::vector<std::string>& names = scene.placing().arms[arm].description.joints;
  const std::string failure = PlacementVerifier(scene, 1.0).verify(improvement, names).failure;
  // The way is no placement, so that something is always missing; only contact matters here.
  if (failure.find("touches") != std::string::npos) found.for_verifier = failure;
  return found;
}

struct Crossing {
  const char* name;
  std::size_t arm;     ///< that moves
  Configuration q;     ///< to where the other rests
  Configuration away;  ///< where the other is out of the way
  const char* other;   ///< how its links are called
};

class RestingArm : public ::testing::TestWithParam<Crossing> {};

TEST_P(RestingArm, IsInTheWayOfPlannerAndVerification) {
  const Crossing& crossing = GetParam();
  const Scene scene = loadPlacementScene(kScene);
  const Obstruction blocked = onTheWay(scene, crossing.arm, crossing.q);
  EXPECT_THAT(blocked.for_planner, HasSubstr(crossing.other));
  EXPECT_THAT(blocked.for_verifier, HasSubstr(crossing.other));
  const Obstruction free =
      onTheWay(withStart(scene, 1 - crossing.arm, crossing.away), crossing.arm, crossing.q);
  EXPECT_EQ(free.for_planner, "");
  EXPECT_EQ(free.for_verifier, "");
}

INSTANTIATE_TEST_SUITE_P(Yumi, RestingArm,
                         ::testing::Values(Crossing{"LeftHand",
                                                    kLeft,
                                                    {-0.4, -0.4, -0.3, 1.3, -0.9, 1.2, 0.5},
                                                    {1.5, -1.95, 0, 0, 0, 0, 0},
                                                    "yumi_right_link"},
                                           Crossing{"LeftObject",
                                                    kLeft,
                                                    {0.4, -1.1, -2.0, 1.0, -3.3, 0.2, 0.8},
                                                    {1.5, -1.95, 0, 0, 0, 0, 0},
                                                    "yumi_right_link"},
                                           Crossing{"RightElbow",
                                                    kRight,
                                                    {-1.4, -2.0, 2.3, -1.4, -1.1, 2.4, 1.7},
                                                    {-1.5, -1.55, 0, 0, 0, 0, 0},
                                                    "yumi_left_link"}),
                         [](const auto& instance) { return std::string(instance.param.name); });

/// The Panda's scene with a second one beside it, which reaches over.
Scene twoPandas(double apart_m) {
  Scene scene = loadPlacementScene("placement/panda_table_cluttered_small_crayons");
  PlacementArm second = scene.placing().arms.front();
  second.name = "second";
  second.X_WB.pretranslate(Eigen::Vector3d(apart_m, 0.0, 0.0));
  scene.placing().arms.push_back(second);
  return scene;
}

TEST(RestingRobot, IsInTheWayOfAnother) {
  Configuration q{0.0, -0.785, 0.0, -2.356, 0.0, 1.571, 0.785};
  q[0] = -1.5;
  const Obstruction blocked = onTheWay(twoPandas(0.35), 0, q);
  EXPECT_THAT(blocked.for_planner, HasSubstr("second: panda_"));
  EXPECT_THAT(blocked.for_verifier, HasSubstr("arm 'second', link 'panda_"));
  const Obstruction free = onTheWay(twoPandas(1.5), 0, q);
  EXPECT_EQ(free.for_planner, "");
  EXPECT_EQ(free.for_verifier, "");
}

TEST(RestingRobot, OneThatStandsInsideAnotherIsRefused) {
  EXPECT_THROW(makePlacementProblem(twoPandas(0.05)), InputError);
}

TEST(RestingArms, TwoGraspsOfOneArmAreNotInEachOthersWay) {
  const PlacementProblem problem = makePlacementProblem(twoPandas(0.0));
  EXPECT_EQ(problem.pdef->getStartStateCount(), 2u);
}

TEST(RestingArms, FingersRestAtTheSceneSOpening) {
  Scene scene = loadPlacementScene(kScene);
  scene.placing().arms[kRight].rest_opening_m = 0.01;
  const ScenePlacementWorld world(scene);
  const Manipulator& robot = *world.arms()[kLeft].robot;
  EXPECT_EQ(robot.description().rest.at("yumi_right_finger_joint1"), 0.005);
  EXPECT_EQ(robot.description().rest.at("yumi_right_finger_joint2"), 0.005);
  EXPECT_EQ(robot.description().rest.at("yumi_right_joint1"), 0.69);
  EXPECT_EQ(robot.description().rest.count("yumi_left_joint1"), 0u);
}

TEST(RestingArms, BothCheckersSeeThem) {
  const Scene scene = loadPlacementScene(kScene);
  const ScenePlacementWorld world(scene);
  std::mt19937_64 random(7);
  for (const ScenePlacementWorld::Arm& arm : world.arms()) {
    const auto fcl = makeFclChecker(arm.checker->problem())->makeContext();
    const auto fast = makeVectorChecker(arm.checker->problem())->makeContext();
    int resting = 0;
    for (int i = 0; i < 3000; ++i) {
      Configuration q;
      for (int j = 0; j < arm.robot->dof(); ++j)
        q.push_back(std::uniform_real_distribution<>(arm.robot->lower()[j], arm.robot->upper()[j])(random));
      ASSERT_EQ(fcl->isFree(q.data(), &arm.grasp), fast->isFree(q.data(), &arm.grasp));
      const std::string pair = fcl->describeCollision(q.data(), &arm.grasp);
      resting += pair.find("yumi_left") != std::string::npos && pair.find("yumi_right") != std::string::npos;
    }
    EXPECT_GT(resting, 100) << "the comparison says nothing about the arm that rests";
  }
}

TEST(RestingArms, ContradictionsAreRefused) {
  const auto complaint = [](const Scene& scene) {
    try {
      makePlacementProblem(scene);
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  Scene scene = loadPlacementScene(kScene);
  EXPECT_THAT(complaint(withStart(scene, kRight, {0.69, 1.0, 0, 0, 0, 0, 0})),
              HasSubstr("place.arms.right.start: joint 'yumi_right_joint2' at 1 is outside its limits"));
  PlacementArm third = scene.placing().arms[kRight];
  third.name = "third";
  third.start[0] = 0.7;
  scene.placing().arms.push_back(third);
  EXPECT_THAT(complaint(scene),
              HasSubstr("place.arms.third.start: joint 'yumi_right_joint1' is at 0.7, but another arm"));
}

/// The first placement found with a seed, verified.
PlacementResult firstPlacement(const std::string& name, std::uint64_t seed) {
  const Scene scene = loadPlacementScene(name);
  PlacementQuerySettings settings;
  settings.seed = seed;
  settings.time_limit_s = 120.0;
  PlacementQuery query(scene, name, settings, "test");
  query.problem().pdef->getOptimizationObjective()->setCostThreshold(ompl::base::Cost(-1.0));
  PlacementResult result = query.solve();
  verifyImprovements(scene, result);
  return result;
}

class YumiScenes : public ::testing::TestWithParam<const char*> {};

TEST_P(YumiScenes, GetAVerifiedPlacement) {
  const PlacementResult result = firstPlacement(GetParam(), 1);
  ASSERT_TRUE(result.solved()) << result.reason;
  EXPECT_TRUE(result.verified()) << firstFailure(result);
}

INSTANTIATE_TEST_SUITE_P(Few, YumiScenes,
                         ::testing::Values("placement/yumi_table_cluttered_large_crayons",
                                           "placement/yumi_table_cluttered_toy_table",
                                           "placement/yumi_cabinet_sparse_small_crayons"));
// For all of them: --gtest_also_run_disabled_tests
INSTANTIATE_TEST_SUITE_P(DISABLED_All, YumiScenes,
                         ::testing::Values("placement/yumi_cabinet_cluttered_large_crayons",
                                           "placement/yumi_cabinet_cluttered_small_crayons",
                                           "placement/yumi_cabinet_cluttered_toy_table",
                                           "placement/yumi_cabinet_cluttered_wine_glass",
                                           "placement/yumi_cabinet_sparse_large_crayons",
                                           "placement/yumi_cabinet_sparse_toy_table",
                                           "placement/yumi_cabinet_sparse_wine_glass",
                                           "placement/yumi_table_cluttered_small_crayons",
                                           "placement/yumi_table_cluttered_wine_glass"));

TEST(TwoArms, BothPlaceOverSeeds) {
  std::set<int> used;
  for (std::uint64_t seed = 1; seed <= 10 && used.size() < 2; ++seed) {
    const PlacementResult result = firstPlacement(kScene, seed);
    ASSERT_TRUE(result.solved()) << result.reason;
    ASSERT_TRUE(result.verified()) << firstFailure(result);
    used.insert(result.improvements.front().arm);
  }
  EXPECT_EQ(used.size(), 2u);
}

TEST(TwoArms, BadScenesAreOneLineAndExitCode2) {
  const std::string text = readFile(std::string(B4P_SOURCE) + "/experiments/scenes/" + kScene + ".yaml");
  const TemporaryFolder folder;
  const std::string file = folder / "scene.yaml", out = folder / "r.json";
  struct Bad {
    std::string from, to, complaint;
  };
  for (const Bad& bad : std::vector<Bad>{
           {"name: right", "name: left", "place.arms[1].name (line 35): is the name of two arms (left)"},
           {"start: [-0.93, -1.55, 0, 0, 0, 0, 0]", "start: [-0.4, -0.4, -0.3, 1.3, -0.9, 1.2, 0.5]",
            "place.arms.left.start: is not free: yumi_left_gripper, yumi_right_link1"},
           {"robot: yumi_right", "robot: yumi_middle", "yumi_middle"},
           {"start: [0.69, -1.95, 0, 0, 0, 0, 0]", "start: [0.69, -1.95]", "does not have 7 numbers"},
       }) {
    writeText(file, replaced(text, bad.from, bad.to));
    const CommandRun run = runB4p("place " + file + " --time-limit-s 1 --out " + out);
    EXPECT_EQ(run.exit_code, 2) << run.out << run.err;
    EXPECT_EQ(run.errorLines(), 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr(bad.complaint));
  }
  EXPECT_EQ(folder.files(), std::vector<std::string>{"scene.yaml"});
}

}  // namespace
}  // namespace b4p::test
