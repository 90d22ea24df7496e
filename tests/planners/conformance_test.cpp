// SPDX-License-Identifier: BSD-3-Clause
// What every planner of this package keeps on a plain OMPL problem: the life cycle of an ob::Planner, its
// status codes, paths that begin and end exactly where they should, and an end in time, whatever the
// problem's functions do.
#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

#include "planners/conformance.h"
#include "planners/field.h"

namespace b4p::test {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double kPlenty_s = 20.0;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// The unit square times ten with a wall at x = 5 that is open above y = 7.
class PlainProblem : public ::testing::TestWithParam<PlannerCase>, protected Field {
 protected:
  PlainProblem() {
    is_valid = [](double px, double py) { return std::abs(px - 5.0) > 0.2 || py > 7.0; };
    planner = GetParam().make(si);
  }

  ob::ProblemDefinitionPtr problem(const ob::ScopedState<>& start, const ob::ScopedState<>& goal) const {
    auto pdef = std::make_shared<ob::ProblemDefinition>(si);
    pdef->addStartState(start);
    pdef->setGoalState(goal);
    return pdef;
  }

  ob::PlannerStatus solve(const ob::ProblemDefinitionPtr& pdef, double time_s) {
    planner->setProblemDefinition(pdef);
    planner->setup();
    return planner->ob::Planner::solve(time_s);
  }

  static og::PathGeometric pathOf(const ob::ProblemDefinitionPtr& pdef) {
    return *pdef->getSolutionPath()->as<og::PathGeometric>();
  }

  void expectPath(const ob::ProblemDefinitionPtr& pdef, const ob::ScopedState<>& start,
                  const ob::ScopedState<>& goal) {
    ASSERT_TRUE(pdef->hasExactSolution());
    og::PathGeometric path = pathOf(pdef);
    ASSERT_GE(path.getStateCount(), 2u);
    EXPECT_EQ(x(path.getState(0)), start[0]);
    EXPECT_EQ(y(path.getState(0)), start[1]);
    EXPECT_EQ(x(path.getStates().back()), goal[0]);
    EXPECT_EQ(y(path.getStates().back()), goal[1]);
    EXPECT_TRUE(path.check());
  }

  ob::PlannerPtr planner;
};

TEST_P(PlainProblem, SolvedFromStartToGoalExactly) {
  const auto start = at(1, 1), goal = at(9, 1);
  const auto pdef = problem(start, goal);
  EXPECT_EQ(solve(pdef, kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  expectPath(pdef, start, goal);
  EXPECT_EQ(pdef->getSolutions().front().plannerName_, planner->getName());
  EXPECT_FALSE(pdef->hasApproximateSolution());
}

TEST_P(PlainProblem, SolveGoesOnAfterASolution) {
  const auto start = at(1, 1), goal = at(9, 1);
  const auto pdef = problem(start, goal);
  EXPECT_EQ(solve(pdef, kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_EQ(planner->ob::Planner::solve(kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_EQ(pdef->getSolutionCount(), 2u);
  expectPath(pdef, start, goal);
}

TEST_P(PlainProblem, SolveGoesOnAfterATimeout) {
  const auto start = at(1, 1), goal = at(9, 1);
  const auto pdef = problem(start, goal);
  std::atomic<bool> open{false};
  is_valid = [&open](double px, double py) { return std::abs(px - 5.0) > 0.2 || (open && py > 7.0); };
  EXPECT_EQ(solve(pdef, 0.1), ob::PlannerStatus::TIMEOUT);
  EXPECT_FALSE(pdef->hasSolution());
  ob::PlannerData before(si);
  planner->getPlannerData(before);
  EXPECT_GT(before.numVertices(), 2u);
  open = true;
  EXPECT_EQ(planner->ob::Planner::solve(kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  ob::PlannerData after(si);
  planner->getPlannerData(after);
  EXPECT_GE(after.numVertices(), before.numVertices());
  expectPath(pdef, start, goal);
}

TEST_P(PlainProblem, ClearForgetsThePastProblem) {
  EXPECT_EQ(solve(problem(at(1, 1), at(9, 1)), kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  planner->clear();
  ob::PlannerData data(si);
  planner->getPlannerData(data);
  EXPECT_EQ(data.numVertices(), 0u);
  const auto start = at(2, 2), goal = at(8, 2);
  const auto second = problem(start, goal);
  EXPECT_EQ(solve(second, kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  expectPath(second, start, goal);
}

TEST_P(PlainProblem, NewProblemDefinitionIsANewProblemWithoutClear) {
  EXPECT_EQ(solve(problem(at(1, 1), at(9, 1)), kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  const auto start = at(2, 2), goal = at(8, 2);
  const auto second = problem(start, goal);
  EXPECT_EQ(solve(second, kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  expectPath(second, start, goal);
}

TEST_P(PlainProblem, NewGoalInTheSameDefinitionIsANewProblemWithoutClear) {
  const auto start = at(1, 1), goal = at(8, 2);
  const auto pdef = problem(start, at(9, 1));
  EXPECT_EQ(solve(pdef, kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  pdef->clearSolutionPaths();
  pdef->setGoalState(goal);
  EXPECT_EQ(planner->ob::Planner::solve(kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  expectPath(pdef, start, goal);
}

TEST_P(PlainProblem, StartEqualToGoalIsSolved) {
  const auto state = at(1, 1);
  const auto pdef = problem(state, state);
  EXPECT_EQ(solve(pdef, kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  expectPath(pdef, state, state);
}

TEST_P(PlainProblem, InvalidStart) {
  EXPECT_EQ(solve(problem(at(5, 1), at(9, 1)), 1.0), ob::PlannerStatus::INVALID_START);
  EXPECT_EQ(solve(problem(at(-1, 1), at(9, 1)), 1.0), ob::PlannerStatus::INVALID_START);
}

TEST_P(PlainProblem, InvalidGoal) {
  EXPECT_EQ(solve(problem(at(1, 1), at(5, 1)), 1.0), ob::PlannerStatus::INVALID_GOAL);
  EXPECT_EQ(solve(problem(at(1, 1), at(11, 1)), 1.0), ob::PlannerStatus::INVALID_GOAL);
}

TEST_P(PlainProblem, NonFiniteStartOrGoalIsInvalid) {
  is_valid = [](double, double) { return true; };
  EXPECT_EQ(solve(problem(at(kNan, 1), at(9, 1)), 1.0), ob::PlannerStatus::INVALID_START);
  EXPECT_EQ(solve(problem(at(1, 1), at(9, kNan)), 1.0), ob::PlannerStatus::INVALID_GOAL);
}

TEST_P(PlainProblem, OneValidStartAmongInvalidOnesIsEnough) {
  auto pdef = std::make_shared<ob::ProblemDefinition>(si);
  for (const auto& start : {at(5, 1), at(kNan, 2), at(1, 1)}) pdef->addStartState(start);
  auto goals = std::make_shared<ob::GoalStates>(si);
  for (const auto& goal : {at(5, 2), at(9, 1)}) goals->addState(goal);
  pdef->setGoal(goals);
  EXPECT_EQ(solve(pdef, kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  expectPath(pdef, at(1, 1), at(9, 1));
}

TEST_P(PlainProblem, MissingGoalIsAnError) {
  auto pdef = std::make_shared<ob::ProblemDefinition>(si);
  pdef->addStartState(at(1, 1));
  planner->setProblemDefinition(pdef);
  EXPECT_THROW(planner->ob::Planner::solve(1.0), ompl::Exception);
}

TEST_P(PlainProblem, GoalThatCannotBeSampledIsNotRecognised) {
  class Somewhere : public ob::Goal {
   public:
    using ob::Goal::Goal;
    bool isSatisfied(const ob::State*) const override { return false; }
  };
  auto pdef = std::make_shared<ob::ProblemDefinition>(si);
  pdef->addStartState(at(1, 1));
  pdef->setGoal(std::make_shared<Somewhere>(si));
  EXPECT_EQ(solve(pdef, 1.0), ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE);
}

TEST_P(PlainProblem, TinyBudgetsEndWithAStatus) {
  for (const double time_s : {0.0, 1e-6, 1e-3}) {
    planner->clear();
    const ob::PlannerStatus status = solve(problem(at(1, 1), at(9, 1)), time_s);
    EXPECT_TRUE(status == ob::PlannerStatus::TIMEOUT || status == ob::PlannerStatus::EXACT_SOLUTION)
        << status.asString();
  }
}

TEST_P(PlainProblem, EndsSoonAfterBeingToldTo) {
  is_valid = [](double px, double) { return std::abs(px - 5.0) > 0.2; };  // no way through
  planner->setProblemDefinition(problem(at(1, 1), at(9, 1)));
  std::atomic<bool> stop{false};
  const ob::PlannerTerminationCondition condition([&stop] { return stop.load(); });
  std::atomic<std::int64_t> told_ns{0};
  const auto now_ns = [] { return std::chrono::steady_clock::now().time_since_epoch().count(); };
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    told_ns = now_ns();
    stop = true;
  });
  const ob::PlannerStatus status = planner->solve(condition);
  const double late_s = 1e-9 * static_cast<double>(now_ns() - told_ns);
  other.join();
  EXPECT_EQ(status, ob::PlannerStatus::TIMEOUT);
  EXPECT_LT(late_s, 1.0);  // the promise is 0.1 s; machines that run tests are busy
}

TEST_P(PlainProblem, ThrowingValidityCheckerEndsInACrashStatus) {
  std::atomic<int> calls{0};
  const auto pdef = problem(at(1, 1), at(9, 1));
  is_valid = [&calls](double px, double) -> bool {
    if (++calls > 500) throw std::runtime_error("validity");
    return std::abs(px - 5.0) > 0.2;
  };
  EXPECT_EQ(solve(pdef, kPlenty_s), ob::PlannerStatus::CRASH);
  EXPECT_FALSE(pdef->hasSolution());
}

TEST_P(PlainProblem, ThrowingGoalEndsInACrashStatus) {
  class Throwing : public ob::GoalSampleableRegion {
   public:
    using ob::GoalSampleableRegion::GoalSampleableRegion;
    void sampleGoal(ob::State*) const override { throw 42; }
    unsigned int maxSampleCount() const override { return 10; }
    double distanceGoal(const ob::State*) const override { return 1.0; }
  };
  auto pdef = std::make_shared<ob::ProblemDefinition>(si);
  pdef->addStartState(at(1, 1));
  pdef->setGoal(std::make_shared<Throwing>(si));
  EXPECT_EQ(solve(pdef, 1.0), ob::PlannerStatus::CRASH);
}

TEST_P(PlainProblem, PlannerDataHoldsStartsGoalsAndProgress) {
  EXPECT_EQ(solve(problem(at(1, 1), at(9, 1)), kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
  ob::PlannerData data(si);
  planner->getPlannerData(data);
  EXPECT_GE(data.numStartVertices(), 1u);
  EXPECT_GE(data.numGoalVertices(), 1u);
  EXPECT_GE(data.numVertices(), 4u);
  // Each tree is one piece, and the solution joins two of them.
  EXPECT_GE(data.numEdges(), data.numVertices() - data.numStartVertices() - data.numGoalVertices());
  for (const auto& [name, read] : planner->getPlannerProgressProperties()) {
    EXPECT_NE(name.find(" INTEGER"), std::string::npos);
    EXPECT_GE(std::stol(read()), 0) << name;
    EXPECT_EQ(data.properties.count(name), 1u);
  }
  EXPECT_EQ(std::stoul(data.properties.at("tree nodes INTEGER")), data.numVertices());
}

TEST_P(PlainProblem, ParametersSayTheirRangeAndRefuseWhatLiesOutside) {
  for (const auto& [name, parameter] : planner->params().getParams()) {
    EXPECT_FALSE(parameter->getRangeSuggestion().empty()) << name;
    const std::string value = parameter->getValue();
    EXPECT_TRUE(planner->params().setParam(name, value)) << name;
    EXPECT_EQ(parameter->getValue(), value) << name;
  }
  if (!planner->params().hasParam("threads")) return;
  EXPECT_THROW(planner->params().setParam("threads", "0"), ompl::Exception);
  EXPECT_EQ(planner->params().getParam("threads")->getValue(), std::to_string(GetParam().threads));
}

TEST_P(PlainProblem, CanBeSolvedManyTimes) {
  for (int i = 0; i < 20; ++i) {
    planner->clear();
    const auto pdef = problem(at(1, 1), at(9, 1));
    ASSERT_EQ(solve(pdef, kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
    expectPath(pdef, at(1, 1), at(9, 1));
  }
}

INSTANTIATE_TEST_SUITE_P(Planners, PlainProblem, ::testing::ValuesIn(plannerCases()), caseName);

}  // namespace
}  // namespace b4p::test
