// SPDX-License-Identifier: BSD-3-Clause
// Promises: the AFR hierarchy loses and doubles nothing; all samples of a placement goal pass all tests and
// beat the threshold, on any number of threads; tree search learns where placements are, and from what it is
// told; pruning leaves out only what cannot win; a failing objective or world ends in a status; one seed, one
// stream; OMPL's planners and B4P run on the goal.
#include <atomic>
#include <limits>
#include <set>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include "placement_toy.h"
#include "planners/b4p/b4p_planner.h"
#include "planners/placement/afr_hierarchy.h"
#include "planners/placement/placement_path_objective.h"
#include "planners/placement/tree_search.h"

namespace b4p::test {
namespace {

namespace ob = ompl::base;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Scoped = ob::ScopedState<ManipulationStateSpace>;

std::shared_ptr<PlacementObjective> flat() {
  return objectiveOf([](double, double) { return 0.0; });
}

TEST(CellTree, LeavesAreTheCellsEachOnce) {
  ContactRegion region = gridRegion(0.0, 0.0, 13, 7);
  region.cells.erase(region.cells.begin() + 20, region.cells.begin() + 31);  // a hole
  const CellTree tree(region);
  std::multiset<int> leaves;
  for (const CellPatch& patch : tree.patches()) {
    ASSERT_LT(patch.begin, patch.end);
    if (patch.children.empty()) {
      ASSERT_EQ(patch.end - patch.begin, 1);
      leaves.insert(tree.order()[static_cast<std::size_t>(patch.begin)]);
    } else {
      EXPECT_LE(patch.children.size(), 4u);
      EXPECT_GE(patch.children.size(), 2u);
    }
    for (int i = patch.begin; i < patch.end; ++i) {
      const Eigen::Vector2d& centre =
          region.cells[static_cast<std::size_t>(tree.order()[static_cast<std::size_t>(i)])];
      for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5})
          EXPECT_LE((centre + region.cell_m * Eigen::Vector2d(x, y) - patch.centre_m).norm(),
                    patch.radius_m + 1e-12);
    }
  }
  EXPECT_EQ(leaves.size(), region.cells.size());
  EXPECT_EQ(std::set<int>(leaves.begin(), leaves.end()).size(), region.cells.size());
}

TEST(AfrHierarchy, EverySampleBelongsToItsNodeAndToNoSibling) {
  ToyPlacement world;
  world.surfaces = {gridRegion(0.0, 0.0, 9, 5), gridRegion(1.0, 0.0, 1, 1, 0.3), gridRegion(2.0, 0.0, 2, 40)};
  world.arms = 2;
  world.faces = 3;
  const AfrHierarchy hierarchy(world);
  std::mt19937_64 random(5);
  for (int walk = 0; walk < 300; ++walk) {
    AfrNode node;
    for (int count; (count = hierarchy.childCount(node)) > 0;) {
      const int number = indexDraw(random, count);
      const AfrNode child = hierarchy.child(node, number);
      if (child.depth >= AfrHierarchy::kFullyChosen) {
        const Placement placement = hierarchy.sample(child, random);
        EXPECT_EQ(placement.arm, child.arm);
        EXPECT_EQ(hierarchy.childOf(node, placement), number);
        EXPECT_LE((placement.p_WV - hierarchy.middle(child).p_WV).norm(), hierarchy.radius_m(child) + 1e-12);
        EXPECT_LE(std::abs(placement.angle_rad - hierarchy.middle(child).angle_rad),
                  AfrHierarchy::angleWidth(child) / 2.0 + 1e-12);
      }
      node = child;
    }
    EXPECT_EQ(node.angle_depth, AfrHierarchy::kAngleDepth);
    EXPECT_NEAR(AfrHierarchy::angleWidth(node), 0.0245, 1e-4);
  }
}

/// Free for object and arm on one side each, and better towards +y.
std::shared_ptr<ToyPlacement> halfWorld() {
  auto world = std::make_shared<ToyPlacement>();
  world->surfaces = {gridRegion(0.0, 0.0, 30, 64), gridRegion(0.3, 0.0, 34, 64),
                     gridRegion(3.0, 3.0, 3, 3, 1.0)};
  world->arms = 2;
  world->object_free = [](double, double, double yaw) { return yaw < 3.0; };
  world->arm_free = [](GraspId arm, double x, double) { return arm == 0 ? x < 0.4 : x > 0.3 && x < 1.0; };
  return world;
}

void expectGood(const ManipulationStateSpace::StateType& s, double threshold) {
  const double x = s.q[0], y = s.q[1];
  EXPECT_TRUE(s.grasp == 0 ? x < 0.4 : s.grasp == 1 && x > 0.3 && x < 1.0);
  EXPECT_LT(s.q[2], 3.0);
  EXPECT_TRUE(x >= 0.0 && x <= 0.64 && y >= 0.0 && y <= 0.64) << x << " " << y;
  EXPECT_GT(y, threshold);
}

TEST(PlacementGoal, SamplesPassAllTestsAndBeatARisingThreshold) {
  for (const PlacementSampling sampling :
       {PlacementSampling::kTreeSearch, PlacementSampling::kUniformChildren, PlacementSampling::kUniformArea})
    for (const bool pose_first : {true, false}) {
      const ToyProblem problem(halfWorld());
      PlacementOptions options;
      options.sampling = sampling;
      options.pose_first = pose_first;
      const auto goal = problem.goal(objectiveOf([](double, double y) { return y; }), options);
      Scoped state(problem.space);
      for (int i = 0; i < 12; ++i) {
        const double threshold = 0.05 * i;
        goal->setObjectiveThreshold(threshold);
        for (int j = 0; j < 5; ++j) {
          ASSERT_TRUE(goal->sample(state.get(), 50000)) << static_cast<int>(sampling) << " " << threshold;
          expectGood(*state.get(), threshold);
          EXPECT_DOUBLE_EQ(goal->objective(state.get()), state->q[1]);
          EXPECT_TRUE(goal->isSatisfied(state.get()));
        }
        goal->setObjectiveThreshold(state->q[1]);
        EXPECT_FALSE(goal->isSatisfied(state.get())) << "equal is not better";
      }
      const PlacementStatistics counts = goal->statistics();
      EXPECT_EQ(counts.valid, 60u);
      EXPECT_EQ(counts.draws, counts.valid + counts.unstable + counts.object_collides + counts.not_better +
                                  counts.hand_collides + counts.unreachable + counts.arm_collides);
    }
}

TEST(PlacementGoal, IsSafeOnManyThreads) {
  const ToyProblem problem(halfWorld());
  const auto goal = problem.goal(objectiveOf([](double, double y) { return y; }));
  constexpr int kThreads = 4, kSamples = 200;
  std::vector<std::thread> threads;
  std::vector<std::vector<std::unique_ptr<Scoped>>> states(kThreads);
  for (int t = 0; t < kThreads; ++t)
    threads.emplace_back([&, t] {
      for (int i = 0; i < kSamples; ++i) {
        auto state = std::make_unique<Scoped>(problem.space);
        if (goal->sample(state->get(), 100000))
          states[static_cast<std::size_t>(t)].push_back(std::move(state));
        goal->isSatisfied(states[static_cast<std::size_t>(t)].front()->get());
        if (i % 50 == 0) {
          goal->setObjectiveThreshold(0.1);
          goal->reportReached(states[static_cast<std::size_t>(t)].back()->get(), 0.1);
        }
      }
    });
  for (std::thread& thread : threads) thread.join();
  std::size_t found = 0;
  for (const auto& of_thread : states)
    for (const auto& state : of_thread) {
      expectGood(*state->get(), -1.0);
      ++found;
    }
  EXPECT_EQ(found, static_cast<std::size_t>(kThreads * kSamples));
  EXPECT_EQ(goal->statistics().valid, found);
}

TEST(PlacementGoal, OneSeedOneStream) {
  const auto stream = [](std::uint64_t seed) {
    const ToyProblem problem(halfWorld());
    const auto goal = problem.goal(flat());
    goal->seed(seed);
    std::vector<double> values;
    Scoped state(problem.space);
    for (int i = 0; i < 50; ++i) {
      goal->sampleGoal(state.get());
      values.insert(values.end(), state->q, state->q + 3);
    }
    return values;
  };
  EXPECT_EQ(stream(7), stream(7));
  EXPECT_NE(stream(7), stream(8));
}

/// Draws until so many valid samples have been found where all that is good lies in one corner.
std::uint64_t drawsInACornerWorld(PlacementSampling sampling, std::uint64_t seed) {
  auto world = std::make_shared<ToyPlacement>();
  world->faces = 3;
  world->object_free = [](double x, double y, double yaw) { return x > 0.56 && y > 0.56 && yaw < 1.5; };
  const ToyProblem problem(world);
  PlacementOptions options;
  options.sampling = sampling;
  const auto goal = problem.goal(flat(), options);
  goal->seed(seed);
  Scoped state(problem.space);
  for (int i = 0; i < 30; ++i) EXPECT_TRUE(goal->sample(state.get(), 1000000));
  return goal->statistics().draws;
}

TEST(TreeSearch, FindsTheGoodCornerInFarFewerDrawsThanUniform) {
  std::uint64_t tree = 0, children = 0, area = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    tree += drawsInACornerWorld(PlacementSampling::kTreeSearch, seed);
    children += drawsInACornerWorld(PlacementSampling::kUniformChildren, seed);
    area += drawsInACornerWorld(PlacementSampling::kUniformArea, seed);
  }
  EXPECT_LT(3 * tree, children) << tree;
  EXPECT_LT(3 * tree, area) << tree;
}

TEST(TreeSearch, LearnsFromWhatWasReachedByOtherMeans) {
  const auto shareInCorner = [](bool told) {
    auto world = std::make_shared<ToyPlacement>();
    world->object_free = [](double, double, double) { return false; };
    const ToyProblem problem(world);
    const auto objective = flat();
    TreeSearch search(*problem.world, *objective, {});
    std::mt19937_64 random(3);
    const auto learn = [&](int draws) {
      int inside = 0;
      for (int i = 0; i < draws; ++i) {
        Placement placement;
        PlacementSampler::Branch branch = 0;
        EXPECT_TRUE(search.draw(random, -1e9, placement, branch));
        search.learn(branch, {});
        inside += placement.p_WV.minCoeff() > 0.48;
      }
      return inside;
    };
    learn(100);
    for (int i = 0; told && i < 20; ++i) search.learnReached({0, 0, 0, {0.6, 0.6}, 1.0});
    return learn(200);
  };
  EXPECT_GT(shareInCorner(true), 2 * shareInCorner(false));
}

/// Half the field is good at first; only a corner of it is better than that.
std::uint64_t drawsForBetterOnes(bool take_back, std::uint64_t seed) {
  const ToyProblem problem(std::make_shared<ToyPlacement>());
  PlacementOptions options;
  options.take_back = take_back;
  const auto goal = problem.goal(objectiveOf([](double x, double y) {
                                   return x > 0.56 && y > 0.56 ? 1.0 : x < 0.32 ? 0.5 : -1.0;
                                 }),
                                 options);
  goal->seed(seed);
  Scoped state(problem.space);
  goal->setObjectiveThreshold(0.0);
  for (int i = 0; i < 300; ++i) EXPECT_TRUE(goal->sample(state.get(), 1000000));
  const std::uint64_t before = goal->statistics().draws;
  goal->setObjectiveThreshold(0.5);
  for (int i = 0; i < 30; ++i) EXPECT_TRUE(goal->sample(state.get(), 1000000));
  return goal->statistics().draws - before;
}

TEST(TreeSearch, LeavesWhatTheThresholdHasMadeWorthless) {
  std::uint64_t taken_back = 0, kept = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    taken_back += drawsForBetterOnes(true, seed);
    kept += drawsForBetterOnes(false, seed);
  }
  EXPECT_LT(taken_back, kept);
}

/// Height of a cone whose top is at (0.4, 0.2); it is 1-Lipschitz.
class Cone : public PlacementObjective {
 public:
  double upperBound(const PoseNeighbourhood& poses) const override {
    return evaluate(poses.X_WO) + poses.radius_m;
  }

 protected:
  double evaluate(const Eigen::Isometry3d& X_WO) const override {
    return -(X_WO.translation().head<2>() - Eigen::Vector2d(0.4, 0.2)).norm();
  }
};

TEST(TreeSearch, PruningFindsTheBestAndProvesThatThereIsNoBetter) {
  for (const bool prune : {false, true}) {
    const ToyProblem problem(std::make_shared<ToyPlacement>());
    PlacementOptions options;
    options.prune = prune;
    const auto goal = problem.goal(std::make_shared<Cone>(), options);
    Scoped state(problem.space);
    while (goal->objectiveThreshold() < -0.004) {
      ASSERT_TRUE(goal->sample(state.get(), 1000000));
      goal->setObjectiveThreshold(goal->objective(state.get()));
    }
    goal->setObjectiveThreshold(0.05);
    EXPECT_FALSE(goal->sample(state.get(), 20000));
    EXPECT_EQ(goal->couldSample(), !prune);
    EXPECT_EQ(goal->statistics().exhausted, prune ? 1u : 0u);
    if (!prune) continue;
    EXPECT_FALSE(goal->sample(state.get(), 1));
    goal->setObjectiveThreshold(-0.01);
    EXPECT_TRUE(goal->couldSample());
    EXPECT_TRUE(goal->sample(state.get(), 1000000));
    EXPECT_GT(goal->objective(state.get()), -0.01);
  }
}

TEST(PlacementGoal, AFailingObjectiveIsAStatusNotACrash) {
  const auto nan = objectiveOf([](double, double) { return std::nan(""); });
  const auto thrower =
      objectiveOf([](double, double) -> double { throw std::runtime_error("broken scales"); });
  const auto odd = objectiveOf([](double, double) -> double { throw 7; });
  for (const auto& [objective, text] :
       {std::pair(nan, "not a number"), {thrower, "broken scales"}, {odd, "unknown type"}}) {
    const ToyProblem problem(std::make_shared<ToyPlacement>());
    const auto goal = problem.goal(objective);
    Scoped state(problem.space);
    EXPECT_FALSE(goal->sample(state.get(), 100));
    EXPECT_FALSE(problem.si->satisfiesBounds(state.get()));
    EXPECT_THAT(goal->problem(), HasSubstr(text));
    EXPECT_FALSE(goal->couldSample());
    EXPECT_EQ(goal->statistics().draws, 1u) << "it is not asked again";
    EXPECT_TRUE(goal->objective().planarGradient(Eigen::Isometry3d::Identity()).isZero());
  }
}

TEST(PlacementGoal, AFailingWorldIsAStatusNotACrash) {
  auto world = std::make_shared<ToyPlacement>();
  world->arm_free = [](GraspId, double, double) -> bool {
    throw std::runtime_error("no contact with the arm");
  };
  const ToyProblem problem(world);
  const auto goal = problem.goal(flat());
  Scoped state(problem.space);
  EXPECT_FALSE(goal->sample(state.get(), 100));
  EXPECT_THAT(goal->problem(), HasSubstr("no contact with the arm"));
}

/// Fails wherever it is asked for an arm, with something that is no std::exception.
struct BrokenArms : ToyPlacement {
  struct Context : ToyPlacementContext {
    using ToyPlacementContext::ToyPlacementContext;
    Eigen::Isometry3d objectPose(GraspId, const double*) override { throw 7; }
    bool armFree(GraspId, const double*) override { throw 7; }
  };
  std::unique_ptr<PlacementContext> makeContext() const override { return std::make_unique<Context>(*this); }
};

TEST(PlacementGoal, WhateverAWorldThrowsStaysInside) {
  const ToyProblem problem(std::make_shared<BrokenArms>());
  Scoped state(problem.space);
  state->q[0] = state->q[1] = state->q[2] = 0.3;
  state->grasp = 0;
  const auto saysWhy = [&](const std::function<void(const PlacementGoal&)>& use) {
    const auto goal = problem.goal(flat());
    EXPECT_NO_THROW(use(*goal));
    EXPECT_THAT(goal->problem(), HasSubstr("unknown type"));
    EXPECT_FALSE(goal->couldSample());
  };
  saysWhy([&](const PlacementGoal& goal) { EXPECT_TRUE(std::isinf(goal.objective(state.get()))); });
  saysWhy([&](const PlacementGoal& goal) { EXPECT_FALSE(goal.isSatisfied(state.get())); });
  saysWhy([&](const PlacementGoal& goal) { goal.reportReached(state.get(), 0.0); });
  Scoped drawn(problem.space);
  saysWhy([&](const PlacementGoal& goal) { EXPECT_FALSE(goal.sample(drawn.get(), 1)); });
}

TEST(PlacementGoal, SaysWhyThereIsNothingToSample) {
  auto world = std::make_shared<ToyPlacement>();
  world->surfaces.clear();
  const ToyProblem bare(world);
  const auto nothing = bare.goal(flat());
  EXPECT_THAT(nothing->problem(), HasSubstr("no surface"));
  EXPECT_FALSE(nothing->couldSample());
  Scoped state(bare.space);
  nothing->sampleGoal(state.get());
  EXPECT_FALSE(bare.si->satisfiesBounds(state.get()));

  auto blocked = std::make_shared<ToyPlacement>();
  blocked->object_free = [](double x, double, double) { return x < 0.1; };
  blocked->arm_free = [](GraspId, double, double) { return false; };
  const ToyProblem problem(blocked);
  const auto goal = problem.goal(flat());
  EXPECT_FALSE(goal->sample(state.get(), 500));
  EXPECT_TRUE(goal->couldSample());
  EXPECT_THAT(goal->statistics().summary(), HasSubstr("0 of 500 draws valid"));
  EXPECT_THAT(goal->statistics().summary(), HasSubstr("object collides"));
  EXPECT_THAT(goal->statistics().summary(), HasSubstr("arm collides"));
}

TEST(PlacementGoal, RefusesWhatMakesNoSense) {
  const ToyProblem problem(std::make_shared<ToyPlacement>());
  const auto refused = [&](auto change) {
    PlacementOptions options;
    change(options);
    EXPECT_THROW(problem.goal(flat(), options), std::invalid_argument);
    EXPECT_NE(options.problem(), "");
  };
  refused([](PlacementOptions& o) { o.exploration = -0.1; });
  refused([](PlacementOptions& o) { o.exploration = std::nan(""); });
  refused([](PlacementOptions& o) { o.attempts = 0; });
  refused([](PlacementOptions& o) { o.ik_attempts = 0; });
  refused([](PlacementOptions& o) { o.postures = 0; });
  refused([](PlacementOptions& o) { o.discount = 0.0; });
  refused([](PlacementOptions& o) { o.stage = 1.1; });
  EXPECT_THROW(problem.goal(nullptr), std::invalid_argument);
  EXPECT_THROW(CallableObjective(nullptr), std::invalid_argument);
}

TEST(PlacementObjective, GradientIsThatOfThePlane) {
  const CallableObjective objective([](const Eigen::Isometry3d& X_WO) {
    return 3.0 * X_WO.translation().x() - 2.0 * X_WO.translation().y() + 0.5 * ToyPlacement::yawOf(X_WO);
  });
  const Eigen::Vector3d gradient = objective.planarGradient(ToyPlacement::pose(0.3, 0.1, 0.7, 1.0));
  EXPECT_TRUE(gradient.isApprox(Eigen::Vector3d(3.0, -2.0, 0.5), 1e-9)) << gradient.transpose();
}

/// Better towards +y, and knows at once where it is below 0.6.
struct BoundedObjective : PlacementObjective {
  mutable std::atomic<int> evaluations{0};
  double evaluate(const Eigen::Isometry3d& X_WO) const override {
    ++evaluations;
    return X_WO.translation().y();
  }
  double quickBound(const Eigen::Isometry3d& X_WO) const override {
    return X_WO.translation().y() < 0.6 ? 0.6 : std::numeric_limits<double>::infinity();
  }
};

TEST(PlacementGoal, WhatABoundRulesOutIsNotEvaluated) {
  const ToyProblem problem(halfWorld());
  const auto objective = std::make_shared<BoundedObjective>();
  const auto goal = problem.goal(objective);
  Scoped state(problem.space);
  goal->setObjectiveThreshold(0.6);
  ASSERT_TRUE(goal->sample(state.get(), 100000));
  expectGood(*state.get(), 0.6);
  const PlacementStatistics counts = goal->statistics();
  EXPECT_GT(counts.not_better, 0u);
  EXPECT_EQ(counts.not_better + counts.unreachable + counts.hand_collides + counts.arm_collides +
                counts.valid + counts.object_collides + counts.unstable,
            counts.draws);
  EXPECT_LE(static_cast<std::uint64_t>(objective->evaluations), counts.arm_collides + counts.valid)
      << "all others are below 0.6";
}

class PlacementPlanning : public ::testing::TestWithParam<const char*> {
 protected:
  static ob::PlannerPtr plannerFor(const ToyProblem& problem) {
    if (std::string(GetParam()) == "RRTConnect")
      return std::make_shared<ompl::geometric::RRTConnect>(problem.si);
    return std::make_shared<B4P>(problem.si);
  }
};

TEST_P(PlacementPlanning, PathEndsInThePlacementAndCostsItsObjective) {
  const ToyProblem problem(halfWorld());
  const auto goal = problem.goal(objectiveOf([](double, double y) { return y; }));
  goal->setObjectiveThreshold(0.5);
  auto pdef = std::make_shared<ob::ProblemDefinition>(problem.si);
  for (const GraspId arm : {0, 1}) {
    Scoped start(problem.space);
    start->q[0] = arm == 0 ? -0.5 : 0.9;
    start->q[1] = start->q[2] = 0.0;
    start->grasp = arm;
    pdef->addStartState(start);
  }
  pdef->setGoal(goal);
  const ob::PlannerPtr planner = plannerFor(problem);
  planner->setProblemDefinition(pdef);
  ASSERT_EQ(planner->solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
  auto& path = *pdef->getSolutionPath()->as<ompl::geometric::PathGeometric>();
  const auto* last = path.getState(path.getStateCount() - 1)->as<ManipulationStateSpace::StateType>();
  expectGood(*last, 0.5);
  EXPECT_EQ(last->grasp, path.getState(0)->as<ManipulationStateSpace::StateType>()->grasp);
  const auto objective = std::make_shared<PlacementPathObjective>(problem.si, goal);
  EXPECT_DOUBLE_EQ(path.cost(objective).value(), last->q[1]);
  EXPECT_TRUE(objective->isCostBetterThan(ob::Cost(0.6), ob::Cost(0.5)));
  EXPECT_FALSE(objective->isSatisfied(ob::Cost(1e9)));
}

TEST_P(PlacementPlanning, AGoalWithNothingToGiveEndsInAStatus) {
  auto bare = halfWorld();
  bare->surfaces.clear();
  const auto nan = objectiveOf([](double, double) { return std::nan(""); });
  for (const auto& [world, objective] : {std::pair(bare, flat()), {halfWorld(), nan}}) {
    const ToyProblem problem(world);
    auto pdef = std::make_shared<ob::ProblemDefinition>(problem.si);
    Scoped start(problem.space);
    start->q[0] = start->q[1] = start->q[2] = 0.0;
    start->grasp = 0;
    pdef->addStartState(start);
    const auto goal = problem.goal(objective);
    pdef->setGoal(goal);
    const ob::PlannerPtr planner = plannerFor(problem);
    planner->setProblemDefinition(pdef);
    int asked = 0;
    const ob::PlannerTerminationCondition never([&asked] { return ++asked > 1000000; });
    EXPECT_FALSE(planner->solve(never));
    EXPECT_LE(asked, 1000000) << "it ends by itself";
    EXPECT_FALSE(pdef->hasSolution());
    EXPECT_NE(goal->problem(), "");
  }
}

INSTANTIATE_TEST_SUITE_P(Planners, PlacementPlanning, ::testing::Values("RRTConnect", "B4P"));

}  // namespace
}  // namespace b4p::test
