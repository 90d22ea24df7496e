// SPDX-License-Identifier: BSD-3-Clause
// Promises of retreat(): a tree leaves its root along straight free ways only, at most the given number of
// nodes in each, and once.
#include "planners/b4p/retreat.h"

#include <gtest/gtest.h>

#include "planners/b4p/b4p_planner.h"
#include "toy_world.h"

namespace b4p {
namespace {

namespace ob = ompl::base;

using State = ManipulationStateSpace::StateType;

constexpr double kStep = 0.5;

/// Four directions: left, right, down, up.
class FourWays : public PickPlaceContext {
 public:
  bool samplePick(double*, GraspId&) override { return false; }
  PlacementId samplePlacement() override { return 0; }
  bool placeRoot(PlacementId, GraspId, double*) override { return false; }
  int retreatDirections() const override { return 4; }
  bool retreat(const double* q, GraspId, int direction, double* next) override {
    const int axis = direction / 2;
    next[axis] = q[axis] + (direction % 2 == 0 ? -kStep : kStep);
    next[1 - axis] = q[1 - axis];
    return true;
  }
};

class RetreatTest : public ::testing::TestWithParam<Side> {
 protected:
  RetreatTest() {
    test::DiscWorld world;
    world.walls = test::wallWithOpening(0.0);
    world.grasps = {{Eigen::Vector2d::Zero(), 0.2}};
    problem = std::make_unique<test::DiscProblem>(world);
    const GraspAccess grasps(problem->si);
    forests = std::make_unique<ForestPair>(problem->si, grasps.distance(), 0);
    motion = std::make_unique<Motion>(problem->si, 0.0);
    scratch = problem->si->allocState();
  }
  ~RetreatTest() override { problem->si->freeState(scratch); }

  Tree& treeAt(double x, double y) {
    auto* state = problem->si->allocState()->as<State>();
    state->q[0] = x;
    state->q[1] = y;
    state->grasp = 0;
    Tree* tree = forests->plant(GetParam(), state, 0, kNoPlacement);
    problem->si->freeState(state);
    return *tree;
  }

  std::unique_ptr<test::DiscProblem> problem;
  std::unique_ptr<ForestPair> forests;
  std::unique_ptr<Motion> motion;
  ob::State* scratch;
  FourWays ways;
};

TEST_P(RetreatTest, GoesAllWaysInTheOpen) {
  Tree& tree = treeAt(2.0, 5.0);
  EXPECT_EQ(retreat(tree, 3, ways, *motion, scratch), 12u);
  EXPECT_EQ(tree.way_out, 3u);
  EXPECT_EQ(forests->nodeCount(), 13u);
}

TEST_P(RetreatTest, EndsBeforeTheFirstMotionThatIsNotFree) {
  // The wall's face is at 4.8 and the disc's radius 0.2: 4.0 and 4.5 are free, 5.0 is not.
  Tree& tree = treeAt(3.5, 5.0);
  EXPECT_EQ(retreat(tree, 6, ways, *motion, scratch), 2u + 3u * 6u);
  forests->forEachNode([this](const Node& node) {
    EXPECT_LT(node.state->as<State>()->q[0], 4.6);
    EXPECT_TRUE(node.parent == nullptr || motion->isFree(node.parent->state, node.state, 0));
  });
}

TEST_P(RetreatTest, SaysThatARootIsBoxedIn) {
  Tree& tree = treeAt(5.0, 5.0);  // inside the wall, where every motion is blocked
  EXPECT_EQ(retreat(tree, 6, ways, *motion, scratch), 0u);
  EXPECT_EQ(tree.way_out, 0u);
}

TEST_P(RetreatTest, TriesWhatTheRegionThinksWorthTryingOnly) {
  class LeftIsShort : public FourWays {
    void retreatReach(const double*, GraspId, int steps, int* reach) override {
      std::fill_n(reach, 4, steps);
      reach[0] = 1;
    }
  } left_is_short;
  Tree& tree = treeAt(2.0, 5.0);
  EXPECT_EQ(retreat(tree, 3, left_is_short, *motion, scratch), 10u);
}

TEST_P(RetreatTest, HappensOnceAndNotAtAllWithoutSteps) {
  Tree& tree = treeAt(2.0, 5.0);
  EXPECT_EQ(retreat(tree, 0, ways, *motion, scratch), 0u);
  EXPECT_EQ(retreat(tree, 2, ways, *motion, scratch), 8u);
  EXPECT_EQ(retreat(tree, 2, ways, *motion, scratch), 0u);
}

INSTANTIATE_TEST_SUITE_P(BothSides, RetreatTest, ::testing::Values(Side::kPick, Side::kPlace));

}  // namespace
}  // namespace b4p
