// SPDX-License-Identifier: BSD-3-Clause
// Promises of takeShortcuts(): a path becomes shorter and stays valid, under its grasp and between its ends;
// no time and no attempts leave it alone; what its validator would not accept is not made.
#include "planners/shortcuts.h"

#include <gtest/gtest.h>

#include "toy_world.h"

namespace b4p {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

using State = ManipulationStateSpace::StateType;

class Shortcuts : public ::testing::Test {
 protected:
  Shortcuts() {
    test::DiscWorld world;
    world.walls = test::wallWithOpening(2.0);
    world.grasps = {{Eigen::Vector2d::Zero(), 0.2}, {Eigen::Vector2d::Zero(), 0.2}};
    problem = std::make_unique<test::DiscProblem>(world);
  }

  /// From (1, 1) to (9, 1) through the opening around (5, 5), in a zigzag.
  og::PathGeometric zigzag() const {
    og::PathGeometric path(problem->si);
    const double points[][2] = {{1, 1}, {1, 9}, {2, 1}, {3, 9}, {4, 5},
                                {6, 5}, {7, 9}, {8, 1}, {9, 9}, {9, 1}};
    ob::State* state = problem->si->allocState();
    for (const auto& point : points) {
      state->as<State>()->q[0] = point[0];
      state->as<State>()->q[1] = point[1];
      state->as<State>()->grasp = 1;
      path.append(state);
    }
    problem->si->freeState(state);
    return path;
  }

  std::unique_ptr<test::DiscProblem> problem;
  const ob::PlannerTerminationCondition never = ob::plannerNonTerminatingCondition();
};

TEST_F(Shortcuts, MakeAPathShorterThatStaysValidUnderItsGrasp) {
  const og::PathGeometric before = zigzag();
  ASSERT_TRUE(before.check());
  og::PathGeometric path(before);
  takeShortcuts(path, 200, never);
  EXPECT_TRUE(path.check());
  // Straight to the opening's middle and on would be 11.3.
  EXPECT_LT(path.length(), 14.0);
  EXPECT_TRUE(problem->si->equalStates(path.getState(0), before.getState(0)));
  EXPECT_TRUE(problem->si->equalStates(path.getStates().back(), before.getState(before.getStateCount() - 1)));
  for (const ob::State* state : path.getStates()) EXPECT_EQ(state->as<State>()->grasp, 1);
}

TEST_F(Shortcuts, LeaveAPathAloneWithoutTimeOrAttempts) {
  const double length = zigzag().length();
  og::PathGeometric path = zigzag();
  takeShortcuts(path, 200, ob::plannerAlwaysTerminatingCondition());
  EXPECT_EQ(path.length(), length);
  takeShortcuts(path, 0, never);
  EXPECT_EQ(path.length(), length);
  EXPECT_EQ(path.getStateCount(), zigzag().getStateCount());
}

/// Accepts the first motion it is asked about; then only those from a way-point of the zigzag to the next one.
class AsFoundOnly : public ob::MotionValidator {
 public:
  AsFoundOnly(const ob::SpaceInformationPtr& si, const og::PathGeometric& path)
      : ob::MotionValidator(si), path_(path) {}
  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    ++asked;
    if (asked <= most) return true;
    for (std::size_t i = 1; i < path_.getStateCount(); ++i)
      if (si_->equalStates(a, path_.getState(i - 1)) && si_->equalStates(b, path_.getState(i))) return true;
    return false;
  }
  bool checkMotion(const ob::State* a, const ob::State* b, std::pair<ob::State*, double>&) const override {
    return checkMotion(a, b);
  }
  mutable int asked = 0;
  int most = 1;

 private:
  const og::PathGeometric path_;
};

TEST_F(Shortcuts, PutBackAPathThatItsValidatorDoesNotAcceptAfterwards) {
  const og::PathGeometric before = zigzag();
  problem->si->setMotionValidator(std::make_shared<AsFoundOnly>(problem->si, before));
  og::PathGeometric path(before);
  takeShortcuts(path, 200, never);
  EXPECT_EQ(path.length(), before.length());
  EXPECT_TRUE(path.check());
}

}  // namespace
}  // namespace b4p
