// SPDX-License-Identifier: BSD-3-Clause
// A reaching scene as a problem: every planner made for it solves it, nothing else is let near, hopeless
// scenes are refused with the reason.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "experiments/fixtures.h"
#include "experiments/preflight.h"
#include "experiments/query.h"
#include "experiments/reach/reach_problem.h"
#include "experiments/runner/runner.h"
#include "experiments/tcp_path_length.h"
#include "experiments/verification/verifier.h"
#include "robots/input_error.h"

namespace b4p::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr const char* kName = "table/above_2";

QuerySettings settings(const std::string& planner) {
  QuerySettings settings;
  settings.planner = planner;
  settings.time_limit_s = 30.0;
  return settings;
}

ReachTask& task(Scene& scene) { return std::get<ReachTask>(scene.task); }

/// The scene with grasps that are full poses: one of a configuration in free space, one that no configuration
/// reaches.
Scene withPoses() {
  Scene scene = loadScene(kName);
  const auto problem = makePlanningProblem(scene);
  const double q[] = {0.6, -0.3, 0.1, -2.0, 0.2, 1.8, 0.5};
  Eigen::Isometry3d far = problem->robot->tcpPose(q);
  far.translation().x() += 0.75;
  ReachTask poses;
  poses.start = task(scene).start;
  poses.X_WT = {far, problem->robot->tcpPose(q)};
  poses.grasp_file = "poses.csv";
  scene.task = poses;
  return scene;
}

class ReachPlanners : public ::testing::TestWithParam<const char*> {
 protected:
  static PlanResult solved(const Scene& scene) {
    Query query(scene, kName, PlannerCatalogue::standard(), settings(GetParam()), "test");
    query.solve();
    PlanResult result = query.result();
    EXPECT_TRUE(result.solved) << result.status;
    result.verification = verify(scene, result);
    EXPECT_TRUE(result.verification.passed) << result.verification.failure;
    return result;
  }
};

TEST_P(ReachPlanners, SolveAndSayWhichPosition) {
  const Scene scene = loadScene(kName);
  const PlanResult result = solved(scene);
  EXPECT_EQ(result.grasp_id, 0);
  EXPECT_EQ(result.path.front(), std::get<ReachTask>(scene.task).start) << "bit for bit";
}

TEST_P(ReachPlanners, SolveAndSayWhichPose) {
  const PlanResult result = solved(withPoses());
  EXPECT_EQ(result.grasp_id, 1);
  ASSERT_TRUE(result.X_WT_reached);
}

TEST_P(ReachPlanners, OneSeedGivesOnePath) {
  const Scene scene = loadScene(kName);
  EXPECT_EQ(solved(scene).path, solved(scene).path);
}

INSTANTIATE_TEST_SUITE_P(All, ReachPlanners,
                         ::testing::Values("b4p", "rrtconnect", "jplus-rrt", "ik-rrt", "bik-rrt", "rrt",
                                           "rrtstar"),
                         [](const auto& planner) {
                           std::string name = planner.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(ReachTasks, RefusePlannersOfPickAndPlaceAndTheOtherWayRound) {
  const auto refusal = [](const char* scene, const char* planner) -> std::string {
    try {
      Query(loadScene(scene), scene, PlannerCatalogue::standard(), settings(planner), "test");
    } catch (const InputError& e) {
      return e.what();
    }
    return "accepted";
  };
  EXPECT_THAT(refusal(kName, "rrt-shared"),
              AllOf(HasSubstr("rrt-shared"), HasSubstr("reaching"), HasSubstr("bik-rrt")));
  EXPECT_THAT(refusal("maze", "bik-rrt"),
              AllOf(HasSubstr("bik-rrt"), HasSubstr("pick and place"), HasSubstr("rrt-shared")));
}

class HopelessReach : public ::testing::Test {
 protected:
  std::string refusal() const {
    try {
      preflight(scene_);
    } catch (const InputError& e) {
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
      return e.what();
    }
    return "accepted";
  }
  Scene scene_ = loadScene(kName);
};

TEST_F(HopelessReach, StartsOutsideTheLimits) {
  task(scene_).start[3] = 0.5;
  EXPECT_THAT(refusal(), AllOf(HasSubstr(scene_.file), HasSubstr("reach.start"),
                               HasSubstr("'panda_joint4' at 0.5"), HasSubstr("limits")));
}

TEST_F(HopelessReach, StartsInCollision) {
  scene_.obstacles.push_back({"post", {Box{{0.1, 0.1, 1.0}}, Eigen::Isometry3d::Identity()}});
  scene_.obstacles.back().shape.X_BS.translation() << 0.3, 0.0, 0.6;
  EXPECT_THAT(refusal(), AllOf(HasSubstr("reach.start"), HasSubstr("panda_"), HasSubstr("post")));
}

TEST_F(HopelessReach, GraspsOutOfReach) {
  scene_ = withPoses();
  EXPECT_EQ(refusal(), "accepted");
  task(scene_).X_WT[1].translation().z() += 2.5;
  EXPECT_THAT(refusal(), AllOf(HasSubstr("poses.csv: row 2"), HasSubstr("is out of reach")));
}

TEST(TcpPathLength, IsThatOfTheTcp) {
  Scene scene = loadScene("maze");
  const auto problem = makePlanningProblem(scene);
  ASSERT_EQ(problem->robot->dof(), 3);
  // Sliding by 3 and 4, then turning by 1 about the body's origin.
  const std::vector<std::vector<double>> path{{0, 0, 0}, {0.3, 0.4, 0}, {0.3, 0.4, 1}};
  const Eigen::Vector3d p_BT =
      problem->robot->tcpPose(path[0].data()).translation() - problem->robot->X_WB().translation();
  EXPECT_NEAR(tcpPathLength_m(*problem->robot, path), 0.5 + p_BT.head<2>().norm(), 1e-4);
  EXPECT_EQ(tcpPathLength_m(*problem->robot, {path[0]}), 0.0);
}

TEST(ReachBenchmark, RecordsGraspAndLengthOfTheTcpsPath) {
  const TemporaryFolder out;
  Experiment experiment;
  experiment.file = experiment.name = "test";
  experiment.runs = 1;
  experiment.time_limit_s = 30.0;
  experiment.scenes = {kName};
  experiment.contenders = {{"bik", "bik-rrt", 1, {}}, {"star", "rrtstar", 1, {}}};
  BenchmarkRunner runner(experiment, PlannerCatalogue::standard(), out.path());
  runner.run();
  ASSERT_EQ(runner.records().size(), 2u);
  for (const RunRecord& record : runner.records()) {
    EXPECT_TRUE(record.verified()) << record.label << record.verification_failure;
    EXPECT_EQ(record.grasp_id, 0);
    const double length_m = std::stod(record.ompl.columns.at("tcp path length REAL"));
    EXPECT_GT(length_m, 0.3) << "from the start to beside it";
    EXPECT_LT(length_m, 30.0);
    EXPECT_LT(record.time_s, 30.0) << "ends with its first path";
  }
  EXPECT_TRUE(std::filesystem::exists(out / "results/table_above_2-bik-1.json"));
}

}  // namespace
}  // namespace b4p::test
