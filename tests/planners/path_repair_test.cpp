// SPDX-License-Identifier: BSD-3-Clause
// Promises (paper, Algorithm 4 with its gaps closed): exactly the colliding runs are replanned, a run at the
// path's end as well; all other way-points stay; a mended path is free; a repair that fails says so and hands
// back what is free.
#include <vector>

#include <gtest/gtest.h>

#include "planners/b4p/path_repair.h"
#include "planners/toy_world.h"

namespace b4p::test {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using StateType = ManipulationStateSpace::StateType;

constexpr unsigned kIterations = 3000;

/// A field with two posts on the line y = 5.
DiscWorld postsWorld() {
  DiscWorld world;
  world.walls = {{{2.8, 4.6}, {3.2, 5.4}}, {{6.8, 4.6}, {7.2, 5.4}}};
  world.grasps = {{{0.0, 0.3}, 0.2}};
  return world;
}

class Repair : public ::testing::Test {
 protected:
  using Points = std::vector<Eigen::Vector2d>;

  og::PathGeometric path(const Points& points) {
    og::PathGeometric path(setup.si);
    ob::State* state = setup.si->allocState();
    for (const auto& point : points) {
      set(state, point);
      path.append(state);
    }
    setup.si->freeState(state);
    return path;
  }

  std::unique_ptr<PathRepair> repairOf(const Points& points, std::size_t first_unchecked = 0,
                                       unsigned iterations = kIterations) {
    ob::State* state = setup.si->allocState();
    set(state, points.front());
    Tree* pick = forests.plant(Side::kPick, state, 0, kNoPlacement);
    set(state, points.back());
    Tree* place = forests.plant(Side::kPlace, state, 0, 0);
    setup.si->freeState(state);
    return std::make_unique<PathRepair>(setup.si, path(points), Junction{pick->root, place->root},
                                        first_unchecked, iterations, motion);
  }

  PathRepair::Status finish(PathRepair& repair) {
    while (const auto attempt = repair.replan(motion)) repair.accept(*attempt);
    return repair.status();
  }

  bool contains(const og::PathGeometric& path, const Eigen::Vector2d& point) {
    for (std::size_t i = 0; i < path.getStateCount(); ++i)
      if (at(path, i) == point) return true;
    return false;
  }

  static Eigen::Vector2d at(const og::PathGeometric& path, std::size_t i) {
    const double* q = path.getState(static_cast<unsigned>(i))->as<StateType>()->q;
    return {q[0], q[1]};
  }

  void expectFree(const og::PathGeometric& path) {
    for (unsigned i = 0; i + 1 < path.getStateCount(); ++i)
      EXPECT_TRUE(setup.si->checkMotion(path.getState(i), path.getState(i + 1))) << "edge " << i;
  }

  DiscProblem setup{postsWorld()};
  ForestPair forests{setup.si, GraspAccess(setup.si).distance(), 0};
  Motion motion{setup.si, 0.0};

 private:
  static void set(ob::State* state, const Eigen::Vector2d& point) {
    auto* s = state->as<StateType>();
    s->q[0] = point.x();
    s->q[1] = point.y();
    s->grasp = 0;
  }
};

TEST_F(Repair, FreePathNeedsNone) {
  const Points points{{1, 2}, {5, 2}, {9, 2}};
  const auto repair = repairOf(points);
  EXPECT_EQ(repair->runCount(), 0u);
  EXPECT_EQ(repair->status(), PathRepair::Status::kSucceeded);
  EXPECT_EQ(repair->repaired().getStateCount(), points.size());
}

TEST_F(Repair, ReplacesExactlyTheCollidingRuns) {
  const Points points{{1, 5}, {2, 5}, {4, 5}, {5, 6}, {6, 5}, {8, 5}, {9, 5}};  // edges 1 and 4 cross posts
  const auto repair = repairOf(points);
  EXPECT_EQ(repair->runCount(), 2u);
  ASSERT_EQ(finish(*repair), PathRepair::Status::kSucceeded);
  const og::PathGeometric mended = repair->repaired();
  expectFree(mended);
  for (const auto& point : points) EXPECT_TRUE(contains(mended, point)) << point.transpose();
  EXPECT_EQ(at(mended, 0), points[0]);
  EXPECT_EQ(at(mended, 1), points[1]);
  EXPECT_EQ(at(mended, mended.getStateCount() - 2), points[5]);
  EXPECT_EQ(at(mended, mended.getStateCount() - 1), points[6]);
}

TEST_F(Repair, AdjacentCollidingEdgesAreOneRun) {
  const Points points{{1, 5}, {3, 5}, {5, 5}, {9, 2}};  // the way-point (3, 5) lies inside a post
  const auto repair = repairOf(points);
  EXPECT_EQ(repair->runCount(), 1u);
  ASSERT_EQ(finish(*repair), PathRepair::Status::kSucceeded);
  expectFree(repair->repaired());
  EXPECT_FALSE(contains(repair->repaired(), {3, 5}));
}

TEST_F(Repair, RunThatReachesTheEndIsRepaired) {
  const Points points{{1, 2}, {5, 5}, {9, 5}};  // the last edge crosses a post
  const auto repair = repairOf(points);
  EXPECT_EQ(repair->runCount(), 1u);
  ASSERT_EQ(finish(*repair), PathRepair::Status::kSucceeded);
  const og::PathGeometric mended = repair->repaired();
  expectFree(mended);
  EXPECT_EQ(at(mended, mended.getStateCount() - 1), points.back());
}

TEST_F(Repair, EdgesKnownToBeFreeAreNotLookedAt) {
  const Points points{{2, 5}, {4, 5}, {5, 5}};  // edge 0 collides, but is declared known
  EXPECT_EQ(repairOf(points, 1)->runCount(), 0u);
}

TEST_F(Repair, FailureHandsBackBothFreeEnds) {
  setup.world->walls.push_back({{4.9, 0.0}, {5.1, DiscWorld::kSize}});  // no way from left to right
  const Points points{{1, 5}, {2, 5}, {4, 5}, {6, 5}, {6, 6}, {8, 6}, {9, 5}};
  const auto repair = repairOf(points, 0, 200);
  EXPECT_EQ(repair->runCount(), 1u);  // edges 1 (post) and 2 (wall) adjoin
  ASSERT_EQ(finish(*repair), PathRepair::Status::kFailed);
  const og::PathGeometric prefix = repair->freePrefix(), suffix = repair->freeSuffix();
  expectFree(prefix);
  expectFree(suffix);
  EXPECT_EQ(at(prefix, 0), points[0]);
  EXPECT_EQ(at(prefix, prefix.getStateCount() - 1), points[1]);
  EXPECT_EQ(at(suffix, 0), points[3]);
  EXPECT_EQ(at(suffix, suffix.getStateCount() - 1), points.back());
}

TEST_F(Repair, MendedRunsBelongToTheFreePrefixOfAFailure) {
  setup.world->walls.push_back({{4.9, 0.0}, {5.1, DiscWorld::kSize}});
  const Points points{{1, 5}, {2, 5}, {4, 5}, {4.4, 5}, {6, 5}, {9, 2}};  // edge 1: a post; edge 3: the wall
  const auto repair = repairOf(points, 0, 1000);
  EXPECT_EQ(repair->runCount(), 2u);
  ASSERT_EQ(finish(*repair), PathRepair::Status::kFailed);
  const og::PathGeometric prefix = repair->freePrefix();
  expectFree(prefix);
  EXPECT_TRUE(contains(prefix, points[3]));
  EXPECT_GT(prefix.getStateCount(), 4u);
}

}  // namespace
}  // namespace b4p::test
