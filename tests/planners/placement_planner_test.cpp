// SPDX-License-Identifier: BSD-3-Clause
// What the anytime placement planner promises: objectives that only rise, paths that are free and end at the
// placement whose objective they claim, the known optimum of small worlds, and an end in time with a status,
// whatever world and objective do.
#include <atomic>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <ompl/base/PlannerData.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "planners/lever_arm.h"
#include "planners/placement/placement_path_objective.h"
#include "planners/placement/placement_planner.h"

namespace b4p::test {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using StateType = ManipulationStateSpace::StateType;

constexpr double kPlenty_s = 30.0;
constexpr double kGoodEnough = -1e-3;
const double kInfinity = std::numeric_limits<double>::infinity();

/// A published improvement.
struct Improvement {
  std::vector<ob::ScopedState<>> states;
  double objective;
};

class Place : public ::testing::Test {
 protected:
  Place() {
    ompl::msg::noOutputHandler();
    ompl::RNG::setSeed(1);
  }

  /// Stops the search at a placement this good.
  static void satisfiedBy(LeverProblem& setup, double objective) {
    auto ranking = std::make_shared<PlacementPathObjective>(setup.si, setup.goal);
    ranking->setCostThreshold(ob::Cost(objective));
    setup.problem->setOptimizationObjective(ranking);
  }

  ob::PlannerStatus solve(LeverProblem& setup, double time_s) {
    planner = std::make_shared<PlacementPlanner>(setup.si);
    return goOn(setup, time_s);
  }

  ob::PlannerStatus goOn(LeverProblem& setup, double time_s) {
    setup.problem->setIntermediateSolutionCallback(
        [this, &setup](const ob::Planner*, const std::vector<const ob::State*>& states, ob::Cost cost) {
          improvements.push_back({{}, cost.value()});
          for (const ob::State* state : states)
            improvements.back().states.emplace_back(setup.si->getStateSpace(), state);
        });
    planner->setProblemDefinition(setup.problem);
    planner->setup();
    return planner->ob::Planner::solve(time_s);
  }

  /// Objectives rise; each path begins at its arm's start, keeps its arm, is free at a finer step than the
  /// planner's and ends on the table where the objective is the one claimed.
  void expectSound(const LeverProblem& setup) const {
    double before = -kInfinity;
    for (const Improvement& improvement : improvements) {
      EXPECT_GT(improvement.objective, before);
      before = improvement.objective;
      ASSERT_GE(improvement.states.size(), 2u);
      const auto* first = improvement.states.front()->as<StateType>();
      const auto* last = improvement.states.back()->as<StateType>();
      EXPECT_TRUE(
          setup.si->equalStates(first, setup.problem->getStartState(static_cast<unsigned>(first->grasp))));
      EXPECT_TRUE(setup.world->stable(setup.objectAt(last)));
      EXPECT_EQ(setup.goal->objective(last), improvement.objective);
      for (std::size_t i = 0; i + 1 < improvement.states.size(); ++i)
        expectFree(setup, improvement.states[i].get(), improvement.states[i + 1].get());
    }
    EXPECT_EQ(planner->bestObjective(), before);
  }

  static void expectFree(const LeverProblem& setup, const ob::State* a, const ob::State* b) {
    EXPECT_EQ(a->as<StateType>()->grasp, b->as<StateType>()->grasp);
    LeverWorld slimmer(*setup.world);
    for (LeverWorld::Block& block : slimmer.blocks) {
      block.min.array() += 0.01;
      block.max.array() -= 0.01;
    }
    ob::ScopedState<> at(setup.si);
    const int pieces = 1 + static_cast<int>(setup.space->jointDistance(a, b) / 0.0007);
    for (int k = 0; k <= pieces; ++k) {
      setup.space->interpolate(a, b, static_cast<double>(k) / pieces, at.get());
      const auto* s = at->as<StateType>();
      // What lies between two checks may touch by as much as half a step moves the object.
      Eigen::Isometry3d X_WO = setup.world->objectAt(s->grasp, s->q);
      X_WO.translation().z() += 0.01;
      ASSERT_TRUE(slimmer.isFree(X_WO));
    }
  }

  std::shared_ptr<PlacementPlanner> planner;
  std::vector<Improvement> improvements;
};

LeverWorld withBlocks() {
  LeverWorld world;
  world.blocks.push_back({{-0.1, -0.6}, {0.1, 0.6}, 0.5});
  world.blocks.push_back({{0.4, 0.2}, {0.6, 0.9}, 0.2});
  return world;
}

TEST_F(Place, KnownOptimumIsReached) {
  LeverProblem setup(withBlocks(), nearTo({0.6, -0.5}));
  satisfiedBy(setup, kGoodEnough);
  EXPECT_EQ(solve(setup, kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_GT(planner->bestObjective(), kGoodEnough);
  expectSound(setup);
}

TEST_F(Place, OptimumBesideAnObstacleIsReached) {
  LeverWorld world;
  world.blocks.push_back({{0.3, -1.0}, {1.0, 1.0}, 0.4});
  LeverProblem setup(world, nearTo({0.5, 0.0}));  // the object's middle may come as near as x = 0.2
  satisfiedBy(setup, -0.097);
  EXPECT_EQ(solve(setup, kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_GT(planner->bestObjective(), -0.097);
  EXPECT_LE(planner->bestObjective(), -0.09 + 1e-6);
  expectSound(setup);
}

TEST_F(Place, SamplingAloneGetsThereToo) {
  LeverProblem setup(withBlocks(), nearTo({0.6, -0.5}));
  satisfiedBy(setup, -0.005);
  planner = std::make_shared<PlacementPlanner>(setup.si);
  planner->params().setParam("local", "0");
  EXPECT_EQ(goOn(setup, kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_GT(planner->bestObjective(), -0.005);
  EXPECT_EQ(planner->getPlannerProgressProperties().at("local steps INTEGER")(), "0");
  expectSound(setup);
}

TEST_F(Place, ArmThatReachesFartherIsTaken) {
  LeverWorld world;
  world.arms[0].farthest_x_m = 0.0;
  LeverProblem setup(world, nearTo({0.6, 0.0}));
  satisfiedBy(setup, kGoodEnough);
  EXPECT_EQ(solve(setup, kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  ASSERT_FALSE(improvements.empty());
  EXPECT_EQ(improvements.back().states.back()->as<StateType>()->grasp, 1);
  expectSound(setup);
}

TEST_F(Place, ArmWithoutAStartIsNotUsed) {
  LeverProblem setup(LeverWorld{}, nearTo({0.6, 0.0}));
  setup.problem->clearStartStates();
  setup.problem->addStartState(setup.holding(1, {-0.8, 0.8, 0.6}));
  satisfiedBy(setup, kGoodEnough);
  EXPECT_EQ(solve(setup, kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  for (const Improvement& improvement : improvements)
    for (const auto& state : improvement.states) EXPECT_EQ(state->as<StateType>()->grasp, 1);
}

TEST_F(Place, BestSolutionComesFirstInTheProblemDefinition) {
  LeverProblem setup(withBlocks(), nearTo({0.6, -0.5}));
  satisfiedBy(setup, kGoodEnough);
  EXPECT_EQ(solve(setup, kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  ASSERT_GT(improvements.size(), 1u);
  const auto solutions = setup.problem->getSolutions();
  EXPECT_EQ(solutions.size(), improvements.size());
  auto& path = *setup.problem->getSolutionPath()->as<og::PathGeometric>();
  EXPECT_EQ(setup.goal->objective(path.getStates().back()), planner->bestObjective());
  EXPECT_EQ(solutions.front().cost_.value(), planner->bestObjective());
  EXPECT_EQ(solutions.front().plannerName_, planner->getName());
  EXPECT_FALSE(setup.problem->hasApproximateSolution());
  expectSound(setup);
}

TEST_F(Place, SolveGoesOn) {
  LeverProblem setup(withBlocks(), nearTo({0.6, -0.5}));
  satisfiedBy(setup, -2.0);
  EXPECT_EQ(solve(setup, kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  const std::size_t before = improvements.size();
  setup.problem->getOptimizationObjective()->setCostThreshold(ob::Cost(kGoodEnough));
  EXPECT_EQ(planner->ob::Planner::solve(kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_GT(planner->bestObjective(), kGoodEnough);
  EXPECT_GE(improvements.size(), before);
  expectSound(setup);
  setup.problem->clearSolutionPaths();
  EXPECT_EQ(planner->ob::Planner::solve(0.0), ob::PlannerStatus::EXACT_SOLUTION);
  ASSERT_TRUE(setup.problem->hasExactSolution()) << "what has been found is said again";
  auto& path = *setup.problem->getSolutionPath()->as<og::PathGeometric>();
  EXPECT_EQ(setup.goal->objective(path.getStates().back()), planner->bestObjective());
}

TEST_F(Place, ClearForgetsAndFreesTheGoalOfItsThreshold) {
  LeverProblem setup(LeverWorld{}, nearTo({0.6, 0.0}));
  setup.goal->setObjectiveThreshold(-1.0);
  satisfiedBy(setup, -0.2);
  EXPECT_EQ(solve(setup, kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_EQ(setup.goal->objectiveThreshold(), planner->bestObjective());
  for (const Improvement& improvement : improvements) EXPECT_GT(improvement.objective, -1.0);
  planner->clear();
  EXPECT_EQ(setup.goal->objectiveThreshold(), -1.0);
  EXPECT_EQ(planner->bestObjective(), -kInfinity);
  ob::PlannerData data(setup.si);
  planner->getPlannerData(data);
  EXPECT_EQ(data.numVertices(), 0u);
  setup.problem->clearSolutionPaths();
  EXPECT_EQ(planner->ob::Planner::solve(kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
}

TEST_F(Place, NothingIsFoundWhereNothingFits) {
  LeverWorld world;
  world.blocks.push_back({{-1.0, -1.0}, {1.0, 1.0}, 0.1});
  LeverProblem setup(world, nearTo({0.0, 0.0}));
  EXPECT_EQ(solve(setup, 0.2), ob::PlannerStatus::TIMEOUT);
  EXPECT_FALSE(setup.problem->hasSolution());
  EXPECT_TRUE(improvements.empty());
  const PlacementStatistics statistics = setup.goal->statistics();
  EXPECT_GT(statistics.object_collides, 0u);
  EXPECT_EQ(statistics.valid, 0u);
  EXPECT_EQ(planner->getPlannerProgressProperties().at("best objective REAL")(), "nan");
}

TEST_F(Place, PlacementsThatNoMotionReachesEndInATimeout) {
  LeverWorld world;
  world.blocks.push_back({{-1.0, -1.0}, {-0.3, 1.0}, 0.2});
  world.blocks.push_back({{-0.2, -2.0}, {-0.1, 2.0}, 5.0});  // higher than the arms can lift over
  LeverProblem setup(world, nearTo({0.5, 0.0}));
  EXPECT_EQ(solve(setup, 0.5), ob::PlannerStatus::TIMEOUT);
  EXPECT_GT(setup.goal->statistics().valid, 0u);
  EXPECT_TRUE(improvements.empty());
}

TEST_F(Place, WorldWithoutASurfaceIsAnInvalidGoal) {
  LeverWorld world;
  world.table.clear();
  LeverProblem setup(world, nearTo({0.0, 0.0}));
  EXPECT_EQ(solve(setup, 1.0), ob::PlannerStatus::INVALID_GOAL);
}

TEST_F(Place, StartsThatAreMissingOrOfNoArmAreInvalid) {
  LeverProblem setup(LeverWorld{}, nearTo({0.0, 0.0}));
  auto start = setup.holding(0, {-0.8, 0.8, 0.6});
  setup.problem->clearStartStates();
  start->as<StateType>()->grasp = kNoGrasp;
  setup.problem->addStartState(start);
  EXPECT_EQ(solve(setup, 1.0), ob::PlannerStatus::INVALID_START);
}

TEST_F(Place, OtherGoalsAreNotRecognised) {
  LeverProblem setup(LeverWorld{}, nearTo({0.0, 0.0}));
  setup.problem->setGoalState(setup.holding(0, {0.0, 0.0, 0.0}));
  EXPECT_EQ(solve(setup, 1.0), ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE);
}

TEST_F(Place, ExceptionsOfTheObjectiveEndInACrashStatus) {
  for (const int good_calls : {0, 50}) {
    std::atomic<int> calls{0};
    LeverProblem setup(LeverWorld{}, [&](const Eigen::Isometry3d& X_WO) {
      if (++calls > good_calls) throw std::runtime_error("no such shelf");
      return -X_WO.translation().head<2>().squaredNorm();
    });
    EXPECT_EQ(solve(setup, kPlenty_s), ob::PlannerStatus::CRASH);
    EXPECT_NE(planner->lastError().find("no such shelf"), std::string::npos) << planner->lastError();
  }
}

TEST_F(Place, NanOfTheObjectiveIsNeverTaken) {
  LeverProblem setup(LeverWorld{}, [](const Eigen::Isometry3d&) { return std::nan(""); });
  EXPECT_EQ(solve(setup, 1.0), ob::PlannerStatus::CRASH);
  EXPECT_TRUE(improvements.empty());
}

TEST_F(Place, ExceptionsOfTheWorldEndInACrashStatus) {
  LeverWorld world;
  std::atomic<int> calls{0};
  world.before_kinematics = [&calls] {
    if (++calls > 10) throw std::runtime_error("encoder");
  };
  LeverProblem setup(world, nearTo({0.6, 0.0}));
  EXPECT_EQ(solve(setup, kPlenty_s), ob::PlannerStatus::CRASH);
  EXPECT_NE(planner->lastError().find("encoder"), std::string::npos) << planner->lastError();
}

TEST_F(Place, ExceptionsOfTheCallbackEndInACrashStatus) {
  LeverProblem setup(LeverWorld{}, nearTo({0.6, 0.0}));
  planner = std::make_shared<PlacementPlanner>(setup.si);
  planner->setProblemDefinition(setup.problem);
  setup.problem->setIntermediateSolutionCallback(
      [](const ob::Planner*, const std::vector<const ob::State*>&, ob::Cost) { throw 7; });
  EXPECT_EQ(planner->ob::Planner::solve(kPlenty_s), ob::PlannerStatus::CRASH);
  EXPECT_TRUE(setup.problem->hasExactSolution()) << "it had been added before";
}

TEST_F(Place, OneSeedGivesTheSameImprovements) {
  const auto run = [this] {
    ompl::RNG::setSeed(5);
    improvements.clear();
    LeverProblem setup(withBlocks(), nearTo({0.6, -0.5}));
    satisfiedBy(setup, kGoodEnough);
    EXPECT_EQ(solve(setup, kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
    std::vector<double> values;
    for (const Improvement& improvement : improvements) {
      values.push_back(improvement.objective);
      for (const auto& state : improvement.states)
        values.insert(values.end(), state->as<StateType>()->q, state->as<StateType>()->q + 6);
    }
    return values;
  };
  const auto first = run();
  EXPECT_GT(first.size(), 10u);
  EXPECT_EQ(first, run());
}

TEST_F(Place, ShortcutsMakePathsShorterAndNothingElse) {
  const auto run = [this](const char* shortcuts) {
    ompl::RNG::setSeed(5);
    improvements.clear();
    LeverProblem setup(withBlocks(), nearTo({0.6, -0.5}));
    satisfiedBy(setup, kGoodEnough);
    planner = std::make_shared<PlacementPlanner>(setup.si);
    planner->params().setParam("shortcuts", shortcuts);
    EXPECT_EQ(goOn(setup, kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
    expectSound(setup);
    std::vector<double> lengths, ends;
    for (const Improvement& improvement : improvements) {
      double length = 0.0;
      for (std::size_t i = 0; i + 1 < improvement.states.size(); ++i)
        length += setup.si->distance(improvement.states[i].get(), improvement.states[i + 1].get());
      lengths.push_back(length);
      const double* q = improvement.states.back()->as<StateType>()->q;
      ends.insert(ends.end(), q, q + 6);
      ends.push_back(improvement.objective);
    }
    return std::pair(lengths, ends);
  };
  const auto [long_ones, ends] = run("0");
  const auto [short_ones, same_ends] = run("50");
  EXPECT_EQ(ends, same_ends);
  double saved = 0.0;
  for (std::size_t i = 0; i < long_ones.size(); ++i) {
    EXPECT_LE(short_ones[i], long_ones[i]);
    saved += long_ones[i] - short_ones[i];
  }
  EXPECT_GT(saved, 0.0);
}

TEST_F(Place, EndsSoonAfterBeingToldTo) {
  LeverProblem setup(withBlocks(), nearTo({0.6, -0.5}));
  planner = std::make_shared<PlacementPlanner>(setup.si);
  planner->setProblemDefinition(setup.problem);
  std::atomic<bool> stop{false};
  std::atomic<std::int64_t> told_ns{0};
  const auto now_ns = [] { return std::chrono::steady_clock::now().time_since_epoch().count(); };
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    told_ns = now_ns();
    stop = true;
  });
  planner->solve(ob::PlannerTerminationCondition([&stop] { return stop.load(); }));
  const double late_s = 1e-9 * static_cast<double>(now_ns() - told_ns);
  other.join();
  EXPECT_LT(late_s, 1.0);  // the promise is 0.1 s; machines that run tests are busy
}

TEST_F(Place, PlannerDataAndProgressSayWhatThereIs) {
  LeverProblem setup(withBlocks(), nearTo({0.6, -0.5}));
  satisfiedBy(setup, kGoodEnough);
  EXPECT_EQ(solve(setup, kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  ob::PlannerData data(setup.si);
  planner->getPlannerData(data);
  EXPECT_EQ(data.numStartVertices(), 2u);
  EXPECT_EQ(std::stoul(data.properties.at("tree nodes INTEGER")), data.numVertices());
  EXPECT_EQ(std::stoul(data.properties.at("improvements INTEGER")), improvements.size());
  EXPECT_NEAR(std::stod(data.properties.at("best objective REAL")), planner->bestObjective(), 1e-6);
  for (const auto& [name, parameter] : planner->params().getParams()) {
    EXPECT_FALSE(parameter->getRangeSuggestion().empty()) << name;
    EXPECT_TRUE(planner->params().setParam(name, parameter->getValue())) << name;
  }
  EXPECT_THROW(planner->params().setParam("slice", "0"), ompl::Exception);
  EXPECT_THROW(planner->params().setParam("local_step", "0"), ompl::Exception);
}

}  // namespace
}  // namespace b4p::test
