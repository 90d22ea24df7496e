// SPDX-License-Identifier: BSD-3-Clause
// The confined scenes that ship are instances of their family, to 1e-9; their dimensions are those of the
// framework they are made after; the start is free, the target stays clear of what it lies on, and no hand is
// inside the target.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "experiments/fixtures.h"
#include "experiments/floating_body.h"
#include "experiments/scene.h"
#include "experiments/scene_families/family.h"
#include "robots/input_error.h"

namespace b4p::test {
namespace {

using ::testing::HasSubstr;

FamilyRequest instance(int group, double step, std::uint64_t seed = 0) {
  FamilyRequest request;
  request.seed = seed;
  request.set = {{"group", group}, {"step", step}};
  return request;
}

const SceneFamily& family() { return findFamily("confined", "test"); }

std::string shippedName(int group, int step) {
  return "confined/0" + std::to_string(group) + std::to_string(step);
}

Scene generated(const TemporaryFolder& folder, FamilyRequest request) {
  request.grasp_file = "scene.grasps.csv";
  writeText(folder / "scene.yaml", generateScene(family(), request, "test"));
  writeText(folder / "scene.grasps.csv", generateGrasps(family(), request, "test"));
  return loadScene(folder / "scene.yaml");
}

const ReachTask& taskOf(const Scene& scene) { return std::get<ReachTask>(scene.task); }

std::vector<double> numbersOf(const PlacedShape& placed) {
  std::vector<double> numbers(placed.X_BS.matrix().data(), placed.X_BS.matrix().data() + 16);
  const auto add = [&](std::initializer_list<double> more) { numbers.insert(numbers.end(), more); };
  if (const auto* box = std::get_if<Box>(&placed.shape)) add({box->size.x(), box->size.y(), box->size.z()});
  if (const auto* ball = std::get_if<Sphere>(&placed.shape)) add({ball->radius});
  if (const auto* rod = std::get_if<Cylinder>(&placed.shape)) add({rod->radius, rod->length});
  if (const auto* rod = std::get_if<Capsule>(&placed.shape)) add({rod->radius, rod->length});
  return numbers;
}

bool isTarget(const Obstacle& obstacle) { return obstacle.name.rfind("target", 0) == 0; }

CollisionProblem problemOf(const Scene& scene) {
  CollisionProblem problem;
  problem.robot = std::make_shared<const Manipulator>(loadUrdf(scene.robot.urdf_file),
                                                      scene.robot.description, scene.X_WB, scene.robot.file);
  problem.obstacles = scene.obstacles;
  problem.edge_step_m = scene.edge_step_m;
  return problem;
}

/// Lowest and highest corner of the obstacles that `chosen` accepts.
template <typename Chosen>
Eigen::AlignedBox3d boundsOf(const Scene& scene, const Chosen& chosen) {
  Eigen::AlignedBox3d bounds;
  for (const Obstacle& obstacle : scene.obstacles) {
    if (!chosen(obstacle)) continue;
    const Eigen::Isometry3d& X = obstacle.shape.X_BS;
    const Eigen::Vector3d axis = X.linear().col(2);
    Eigen::Vector3d half = Eigen::Vector3d::Zero();
    if (const auto* box = std::get_if<Box>(&obstacle.shape.shape))
      half = X.linear().cwiseAbs() * box->size / 2;
    if (const auto* ball = std::get_if<Sphere>(&obstacle.shape.shape)) half.setConstant(ball->radius);
    if (const auto* rod = std::get_if<Capsule>(&obstacle.shape.shape))
      half = axis.cwiseAbs() * rod->length / 2 + Eigen::Vector3d::Constant(rod->radius);
    if (const auto* rod = std::get_if<Cylinder>(&obstacle.shape.shape))
      half = axis.cwiseAbs() * rod->length / 2 +
             rod->radius * (Eigen::Vector3d::Ones() - axis.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
    bounds.extend(Eigen::AlignedBox3d(X.translation() - half, X.translation() + half));
  }
  return bounds;
}

/// Distance between two named boxes along x.
double gapBetween(const Scene& scene, const std::string& left, const std::string& right) {
  const auto named = [](const std::string& name) {
    return [name](const Obstacle& obstacle) { return obstacle.name == name; };
  };
  return boundsOf(scene, named(right)).min().x() - boundsOf(scene, named(left)).max().x();
}

class ConfinedScenes : public ::testing::TestWithParam<int> {
 protected:
  int group() const { return GetParam() / 10; }
  int step() const { return GetParam() % 10; }
  Scene shipped() const { return loadScene(shippedName(group(), step())); }
};

TEST_P(ConfinedScenes, ShippedOneIsMadeAgainByItsFamily) {
  const TemporaryFolder folder;
  const Scene scene = shipped(), again = generated(folder, instance(group(), step()));
  EXPECT_EQ(scene.name, "confined_0" + std::to_string(GetParam()));
  EXPECT_EQ(scene.robot.file, again.robot.file);
  EXPECT_EQ(scene.edge_step_m, again.edge_step_m);
  EXPECT_EQ(scene.budget_s, again.budget_s);
  EXPECT_TRUE(scene.X_WB.isApprox(again.X_WB, 1e-9));
  ASSERT_EQ(scene.obstacles.size(), again.obstacles.size());
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
    EXPECT_EQ(scene.obstacles[i].name, again.obstacles[i].name);
    EXPECT_THAT(numbersOf(scene.obstacles[i].shape),
                ::testing::Pointwise(::testing::DoubleNear(1e-9), numbersOf(again.obstacles[i].shape)));
  }
  EXPECT_THAT(taskOf(scene).start, ::testing::Pointwise(::testing::DoubleNear(1e-9), taskOf(again).start));
  ASSERT_EQ(taskOf(scene).X_WT.size(), 200u);
  for (std::size_t i = 0; i < 200; ++i)
    EXPECT_LT((taskOf(scene).X_WT[i].matrix() - taskOf(again).X_WT.at(i).matrix()).cwiseAbs().maxCoeff(),
              1e-9);
}

TEST_P(ConfinedScenes, StartIsFreeAndHandsAreClearOfTheTarget) {
  const Scene scene = shipped();
  CollisionProblem problem = problemOf(scene);
  EXPECT_EQ(makeFclChecker(problem)->makeContext()->describeCollision(taskOf(scene).start.data(), nullptr),
            "");
  std::vector<Obstacle> target;
  std::copy_if(scene.obstacles.begin(), scene.obstacles.end(), std::back_inserter(target), isTarget);
  ASSERT_FALSE(target.empty());
  problem.obstacles = target;
  FloatingBody hand(*FloatingBody::makeChecker(problem, FloatingBody::Parts::kGripper));
  Grasp open;
  open.opening_m = 0.08;
  for (const Eigen::Isometry3d& X_WT : taskOf(scene).X_WT) EXPECT_EQ(hand.describeCollision(X_WT, open), "");
}

TEST_P(ConfinedScenes, TargetIsWhereTheFrameworkHasIt) {
  const Scene scene = shipped();
  const Eigen::AlignedBox3d target = boundsOf(scene, isTarget);
  const double past = step() - 1.0;
  const auto expectBounds = [&](const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    EXPECT_LT((target.min() - low).cwiseAbs().maxCoeff(), 1.5e-3) << target.min().transpose();
    EXPECT_LT((target.max() - high).cwiseAbs().maxCoeff(), 1.5e-3) << target.max().transpose();
  };
  switch (group()) {
    case 1:
      EXPECT_NEAR(target.center().z(), 0.52, 3e-3);
      EXPECT_NEAR(target.center().y(), 0.6 + 0.15 + 0.1 * past, 0.02);
      EXPECT_NEAR(target.sizes().z(), 0.034, 1e-9);
      EXPECT_NEAR(gapBetween(scene, "shelf_left", "shelf_right"), 0.40, 1e-9);
      break;
    case 2:
      EXPECT_NEAR(target.center().x(), 1.0, 1e-9);
      EXPECT_NEAR(target.center().y(), 0.6 + 0.2 + 0.1 * past, 1e-9);
      EXPECT_NEAR(target.sizes().z(), 0.067, 1e-9);
      break;
    case 3:
      expectBounds({0.823, 0.718, 0.001}, {1.002, 0.769, 0.096});
      EXPECT_NEAR(gapBetween(scene, "wall_left", "wall_right"), 0.64 - 0.08 * past, 1e-9);
      break;
    default:
      expectBounds({0.902, 1.203, 0.501}, {1.101, 1.282, 0.543});
      EXPECT_NEAR(gapBetween(scene, "gate_left", "gate_right"), 0.86 - 0.08 * past, 1e-9);
      break;
  }
}

INSTANTIATE_TEST_SUITE_P(All, ConfinedScenes,
                         ::testing::Values(11, 12, 13, 14, 15, 21, 22, 23, 24, 25, 31, 32, 33, 34, 35, 41, 42,
                                           43, 44, 45),
                         [](const auto& id) { return "Scenario0" + std::to_string(id.param); });

TEST(ConfinedFamily, SameRequestSameBytesAnotherSeedOtherGrasps) {
  const FamilyRequest request = instance(2, 3, 5);
  EXPECT_EQ(generateGrasps(family(), request, "test"), generateGrasps(family(), request, "test"));
  EXPECT_NE(generateGrasps(family(), request, "test"), generateGrasps(family(), instance(2, 3, 6), "test"));
}

TEST(ConfinedFamily, StepsBetweenAreGapsBetween) {
  const TemporaryFolder folder;
  const Scene scene = generated(folder, instance(3, 2.5));
  EXPECT_NEAR(gapBetween(scene, "wall_left", "wall_right"), 0.52, 1e-9);
}

TEST(ConfinedFamily, EndsOfEveryRangeLoad) {
  const TemporaryFolder folder;
  for (const FamilyParameter& p : family().parameters)
    for (const double value : {p.low, p.high}) {
      FamilyRequest request;
      request.set = {{p.name, value}};
      EXPECT_NO_THROW(generated(folder, request)) << p.name << " " << value;
    }
}

TEST(ConfinedFamily, CommandWritesSceneAndGraspsTogether) {
  const TemporaryFolder folder;
  const CommandRun run = runB4p("generate confined --set group=2 --set step=4.5 --seed 3 --out \"" +
                                folder / "mine: #1.yaml" + "\"");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(folder.files(), ::testing::ElementsAre("mine: #1.grasps.csv", "mine: #1.yaml"));
  const Scene scene = loadScene(folder / "mine: #1.yaml");
  EXPECT_EQ(taskOf(scene).X_WT.size(), 200u);
}

TEST(ConfinedFamily, RefusesOtherGroups) {
  for (const double group : {0.0, 1.5, 5.0}) {
    FamilyRequest request;
    request.set["group"] = group;
    EXPECT_THROW(generateScene(family(), request, "test"), InputError);
    EXPECT_THROW(generateGrasps(family(), request, "test"), InputError);
  }
}

}  // namespace
}  // namespace b4p::test
