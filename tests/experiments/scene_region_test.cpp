// SPDX-License-Identifier: BSD-3-Clause
// The region's draws hold the object where they say, depend on their seed alone, and its tables serve many
// threads.
#include "experiments/scene_region.h"
#include "experiments/floating_body.h"

#include <gtest/gtest.h>

#include <memory>
#include <thread>
#include <vector>

#include "experiments/fixtures.h"
#include "experiments/problem.h"

namespace b4p::test {
namespace {

constexpr double kPositionTolerance_m = 1e-4;

Problem planarProblem() {
  static const SceneCopy copy;
  return makeProblem(loadScene(copy.scene()));
}

Problem pandaProblem() { return makeProblem(loadScene("grocery")); }

/// Draws until a pick is found.
GraspId pick(PickPlaceContext& context, std::vector<double>& q) {
  constexpr int kMostDraws = 10000;
  GraspId grasp = kNoGrasp;
  for (int draw = 0; draw < kMostDraws; ++draw)
    if (context.samplePick(q.data(), grasp)) return grasp;
  ADD_FAILURE() << "no pick found";
  return kNoGrasp;
}

TEST(SceneRegion, KnowsAFiniteFamilyFromTheStartAndAContinuumByWhatWasDrawn) {
  EXPECT_EQ(planarProblem().region->graspCount(), 4);
  const Problem panda = pandaProblem();
  EXPECT_EQ(panda.region->graspCount(), 0);
  std::vector<double> q(7);
  const auto context = panda.region->makeContext(1);
  EXPECT_EQ(pick(*context, q), 0);
  EXPECT_EQ(pick(*context, q), 1);
  EXPECT_EQ(panda.region->graspCount(), 2);
}

TEST(SceneRegion, PicksForAPlacementLeaveTheHandRoomThere) {
  const Problem panda = pandaProblem();
  const auto context = panda.region->makeContext(1);
  const auto hand_checker = FloatingBody::makeChecker(panda.checker->problem(), FloatingBody::Parts::kGripper,
                                                      *makeFclChecker(panda.checker->problem()));
  FloatingBody hand(*hand_checker);
  std::vector<double> q(7);
  int picks = 0;
  for (int draw = 0; draw < 2000 && picks < 20; ++draw) {
    GraspId id = kNoGrasp;
    const PlacementId placement = context->samplePlacement();
    if (!context->samplePickFor(placement, q.data(), id)) continue;
    ++picks;
    const Grasp& grasp = panda.region->grasp(id);
    EXPECT_TRUE(hand.isFree(panda.region->placement(placement) * grasp.X_OT, grasp));
    EXPECT_TRUE(panda.checker->makeContext()->isFree(q.data(), &grasp));
  }
  EXPECT_EQ(picks, 20);
}

TEST(SceneRegion, PicksHoldTheObjectAtItsStartPoseAndAreFree) {
  for (const Problem& problem : {planarProblem(), pandaProblem()}) {
    const auto context = problem.region->makeContext(5);
    const auto collisions = problem.checker->makeContext();
    std::vector<double> q(problem.space->dof());
    for (int i = 0; i < 5; ++i) {
      const Grasp& grasp = problem.region->grasp(pick(*context, q));
      const Eigen::Isometry3d X_WO = problem.region->objectPose(q.data(), grasp);
      EXPECT_LT((X_WO.translation() - problem.scene.pickPlace().X_WO_start.translation()).norm(),
                kPositionTolerance_m);
      EXPECT_TRUE(X_WO.linear().isApprox(problem.scene.pickPlace().X_WO_start.linear(), 1e-3));
      EXPECT_TRUE(collisions->isFree(q.data(), &grasp));
    }
  }
}

TEST(SceneRegion, PlaceRootsLieInsideTheRegion) {
  const Problem problem = planarProblem();
  const auto context = problem.region->makeContext(6);
  std::vector<double> q(problem.space->dof());
  int found = 0;
  for (int i = 0; i < 40; ++i) {
    const PlacementId placement = context->samplePlacement();
    const GraspId grasp = i % 4;
    if (!context->placeRoot(placement, grasp, q.data())) continue;
    ++found;
    EXPECT_EQ(problem.region->distanceToPlacement(q.data(), grasp), 0.0);
    const Eigen::Vector3d p =
        problem.region->objectPose(q.data(), problem.region->grasp(grasp)).translation();
    EXPECT_LT((p - problem.region->placement(placement).translation()).norm(), kPositionTolerance_m);
  }
  EXPECT_GT(found, 10);
}

TEST(SceneRegion, DrawsDependOnTheSeedAlone) {
  const auto draws = [](std::uint64_t seed) {
    const Problem problem = pandaProblem();
    const auto context = problem.region->makeContext(seed);
    std::vector<double> all, q(7);
    for (int i = 0; i < 3; ++i) {
      pick(*context, q);
      all.insert(all.end(), q.begin(), q.end());
    }
    return all;
  };
  EXPECT_EQ(draws(1), draws(1));
  EXPECT_NE(draws(1), draws(2));
}

TEST(SceneRegion, TablesServeManyThreads) {
  const Problem problem = pandaProblem();
  constexpr int kThreads = 4, kPicks = 3, kPlacements = 200;
  std::vector<std::vector<GraspId>> found(kThreads);
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t)
    threads.emplace_back([&problem, &mine = found[static_cast<std::size_t>(t)], t] {
      const auto context = problem.region->makeContext(static_cast<std::uint64_t>(t));
      std::vector<double> q(7);
      for (int i = 0; i < kPicks; ++i) mine.push_back(pick(*context, q));
      for (int i = 0; i < kPlacements; ++i) problem.region->placement(context->samplePlacement());
    });
  for (std::thread& thread : threads) thread.join();
  std::vector<int> seen(kThreads * kPicks, 0);
  EXPECT_EQ(problem.region->graspCount(), kThreads * kPicks);
  for (const auto& ids : found)
    for (const GraspId id : ids) ++seen.at(static_cast<std::size_t>(id));
  EXPECT_EQ(seen, std::vector<int>(kThreads * kPicks, 1)) << "each grasp has one number of its own";
}

}  // namespace
}  // namespace b4p::test
