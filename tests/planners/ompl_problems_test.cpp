// SPDX-License-Identifier: BSD-3-Clause
// The drop-in promise: B4P, the baselines (which are all alike here) and RedirectableRRTConnect solve,
// without grasps and on any state space, the kinds of problem that OMPL tests its own planners with: circles
// in the plane, a map, rigid bodies in SE(2) and SE(3), the corridor along a hypercube's edges, a chain in
// SO(2)^n, a car that cannot go sideways, goal regions that are sampled while it plans, and several starts.
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <ompl/base/goals/GoalLazySamples.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/util/Console.h>

#include "planners/conformance.h"
#include "planners/manhattan_space.h"

namespace b4p::test {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double kPlenty_s = 60.0;
const double kPi = std::acos(-1.0);

using RealVector = ob::RealVectorStateSpace::StateType;

class OmplProblem : public ::testing::TestWithParam<PlannerCase> {
 protected:
  OmplProblem() { ompl::msg::noOutputHandler(); }

  void expectSolved(og::SimpleSetup& setup) {
    setup.setPlanner(GetParam().make(setup.getSpaceInformation()));
    ASSERT_EQ(setup.solve(kPlenty_s), ob::PlannerStatus::EXACT_SOLUTION);
    og::PathGeometric& path = setup.getSolutionPath();
    EXPECT_TRUE(path.check());
    EXPECT_TRUE(setup.getGoal()->isSatisfied(path.getStates().back()));
    setup.simplifySolution(1.0);
    EXPECT_TRUE(setup.getSolutionPath().check());
  }
};

TEST_P(OmplProblem, CirclesInThePlane) {
  struct Circle {
    double x, y, r;
  };
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0.0, 10.0), radius(0.3, 0.7);
  std::vector<Circle> circles;
  while (circles.size() < 30) {
    const Circle c{place(random), place(random), radius(random)};
    if (std::hypot(c.x - 0.5, c.y - 0.5) > 1.2 && std::hypot(c.x - 9.5, c.y - 9.5) > 1.2)
      circles.push_back(c);
  }
  auto space = std::make_shared<ob::RealVectorStateSpace>(2);
  space->setBounds(0.0, 10.0);
  og::SimpleSetup setup(space);
  setup.getSpaceInformation()->setStateValidityCheckingResolution(0.001);
  setup.setStateValidityChecker([&circles](const ob::State* state) {
    const double* v = state->as<RealVector>()->values;
    for (const Circle& c : circles)
      if (std::hypot(v[0] - c.x, v[1] - c.y) <= c.r) return false;
    return true;
  });
  ob::ScopedState<> start(space), goal(space);
  start[0] = start[1] = 0.5;
  goal[0] = goal[1] = 9.5;
  setup.setStartAndGoalStates(start, goal);
  expectSolved(setup);
}

TEST_P(OmplProblem, Map) {
  const std::vector<std::string> map{
      "..........", ".########.", ".#......#.", ".#.####.#.", ".#.#..#.#.",
      ".#.#.##.#.", ".#.#....#.", ".#.######.", ".#........", ".#########",
  };
  auto space = std::make_shared<ob::RealVectorStateSpace>(2);
  space->setBounds(0.0, 9.999);
  og::SimpleSetup setup(space);
  setup.getSpaceInformation()->setStateValidityCheckingResolution(0.001);
  setup.setStateValidityChecker([&map](const ob::State* state) {
    const double* v = state->as<RealVector>()->values;
    return map[static_cast<std::size_t>(v[1])][static_cast<std::size_t>(v[0])] == '.';
  });
  ob::ScopedState<> start(space), goal(space);
  start[0] = 0.5, start[1] = 9.5;
  goal[0] = 5.5, goal[1] = 4.5;
  setup.setStartAndGoalStates(start, goal);
  expectSolved(setup);
}

TEST_P(OmplProblem, RodThroughAGapInSE2) {
  auto space = std::make_shared<ob::SE2StateSpace>();
  ob::RealVectorBounds bounds(2);
  bounds.setLow(0.0);
  bounds.setHigh(4.0);
  space->setBounds(bounds);
  og::SimpleSetup setup(space);
  setup.getSpaceInformation()->setStateValidityCheckingResolution(0.002);
  setup.setStateValidityChecker([](const ob::State* state) {
    const auto* s = state->as<ob::SE2StateSpace::StateType>();
    constexpr double kHalfLength = 0.5;
    constexpr int kPoints = 20;
    for (int i = -kPoints; i <= kPoints; ++i) {
      const double along = kHalfLength * i / kPoints;
      const double x = s->getX() + along * std::cos(s->getYaw()),
                   y = s->getY() + along * std::sin(s->getYaw());
      if (std::abs(x - 2.0) < 0.2 && std::abs(y - 2.0) > 0.2) return false;
      if (x < 0.0 || x > 4.0 || y < 0.0 || y > 4.0) return false;
    }
    return true;
  });
  ob::ScopedState<ob::SE2StateSpace> start(space), goal(space);
  start->setXY(1.0, 1.0);
  start->setYaw(kPi / 2.0);
  goal->setXY(3.0, 3.0);
  goal->setYaw(kPi / 2.0);
  setup.setStartAndGoalStates(start, goal);
  expectSolved(setup);
}

TEST_P(OmplProblem, PlateThroughAHoleInSE3) {
  auto space = std::make_shared<ob::SE3StateSpace>();
  ob::RealVectorBounds bounds(3);
  bounds.setLow(-2.0);
  bounds.setHigh(2.0);
  space->setBounds(bounds);
  og::SimpleSetup setup(space);
  setup.getSpaceInformation()->setStateValidityCheckingResolution(0.005);
  setup.setStateValidityChecker([](const ob::State* state) {
    const auto* s = state->as<ob::SE3StateSpace::StateType>();
    const auto& r = s->rotation();
    // Tips of the plate's two half axes in its plane.
    const double ux = 1 - 2 * (r.y * r.y + r.z * r.z), uy = 2 * (r.x * r.y + r.z * r.w),
                 uz = 2 * (r.x * r.z - r.y * r.w);
    constexpr double kHalfLength = 0.6;
    for (const double along : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
      const double x = s->getX() + kHalfLength * along * ux, y = s->getY() + kHalfLength * along * uy,
                   z = s->getZ() + kHalfLength * along * uz;
      if (std::abs(x) < 0.15 && (std::abs(y) > 0.5 || std::abs(z) > 0.5)) return false;
    }
    return true;
  });
  ob::ScopedState<ob::SE3StateSpace> start(space), goal(space);
  start->setXYZ(-1.2, 1.0, 0.0);
  start->rotation().setAxisAngle(0, 0, 1, kPi / 2.0);
  goal->setXYZ(1.2, -1.0, 0.0);
  goal->rotation().setAxisAngle(0, 0, 1, kPi / 2.0);
  setup.setStartAndGoalStates(start, goal);
  expectSolved(setup);
}

TEST_P(OmplProblem, EdgesOfAHypercube) {
  constexpr unsigned kDimension = 5;
  constexpr double kWidth = 0.15;
  auto space = std::make_shared<ob::RealVectorStateSpace>(kDimension);
  space->setBounds(0.0, 1.0);
  og::SimpleSetup setup(space);
  setup.getSpaceInformation()->setStateValidityCheckingResolution(0.001);
  // Free: near the chain of edges (0,0,..) - (1,0,..) - (1,1,0,..) - ... - (1,1,..).
  setup.setStateValidityChecker([](const ob::State* state) {
    const double* v = state->as<RealVector>()->values;
    unsigned k = 0;
    while (k < kDimension && v[k] > 1.0 - kWidth) ++k;
    for (++k; k < kDimension; ++k)
      if (v[k] > kWidth) return false;
    return true;
  });
  ob::ScopedState<> start(space), goal(space);
  for (unsigned i = 0; i < kDimension; ++i) {
    start[i] = 0.0;
    goal[i] = 1.0;
  }
  setup.setStartAndGoalStates(start, goal);
  expectSolved(setup);
}

TEST_P(OmplProblem, ChainOfAngles) {
  auto space = std::make_shared<ob::CompoundStateSpace>();
  constexpr unsigned kLinks = 4;
  for (unsigned i = 0; i < kLinks; ++i) space->addSubspace(std::make_shared<ob::SO2StateSpace>(), 1.0);
  og::SimpleSetup setup(space);
  setup.getSpaceInformation()->setStateValidityCheckingResolution(0.002);
  setup.setStateValidityChecker([](const ob::State* state) {
    const auto* s = state->as<ob::CompoundState>();
    double x = 0.0, y = 0.0, angle = 0.0;
    for (unsigned i = 0; i < kLinks; ++i) {
      angle += s->as<ob::SO2StateSpace::StateType>(i)->value;
      for (int k = 0; k < 10; ++k) {
        x += 0.025 * std::cos(angle);
        y += 0.025 * std::sin(angle);
        if (std::abs(x) < 0.1 && y > 0.35) return false;  // a wall above the base
      }
    }
    return true;
  });
  ob::ScopedState<> start(space), goal(space);
  for (unsigned i = 0; i < kLinks; ++i) start[i] = goal[i] = 0.0;
  start[0] = kPi / 4.0;
  goal[0] = 3.0 * kPi / 4.0;
  setup.setStartAndGoalStates(start, goal);
  expectSolved(setup);
}

TEST_P(OmplProblem, MotionsThatHaveADirection) {
  auto space = std::make_shared<ManhattanSpace>();
  space->setBounds(0.0, 6.0);
  og::SimpleSetup setup(space);
  setup.getSpaceInformation()->setStateValidityCheckingResolution(0.002);
  setup.setStateValidityChecker([](const ob::State* state) {
    const double* v = state->as<RealVector>()->values;
    const bool in_wall = std::abs(v[0] - 3.0) < 0.3 && v[1] < 3.5;
    const bool in_ledge = std::abs(v[1] - 3.0) < 0.1 && v[0] > 0.5 && v[0] < 3.0;
    return !in_wall && !in_ledge;
  });
  ob::ScopedState<> start(space), goal(space);
  start[0] = start[1] = 1.0;
  goal[0] = 5.0;
  goal[1] = 1.0;
  setup.setStartAndGoalStates(start, goal);
  expectSolved(setup);
}

TEST_P(OmplProblem, SeveralStartsAndGoalsSampledMeanwhile) {
  auto space = std::make_shared<ob::RealVectorStateSpace>(2);
  space->setBounds(0.0, 10.0);
  og::SimpleSetup setup(space);
  setup.getSpaceInformation()->setStateValidityCheckingResolution(0.001);
  // Of three rooms only the middle one has a way to the goals.
  setup.setStateValidityChecker([](const ob::State* state) {
    const double* v = state->as<RealVector>()->values;
    const bool in_wall = std::abs(v[1] - 3.3) < 0.1 || std::abs(v[1] - 6.6) < 0.1;
    const bool in_door = std::abs(v[0] - 8.0) < 0.1 && !(v[1] > 4.5 && v[1] < 5.5);
    return !in_wall && !in_door;
  });
  for (const double y : {1.0, 5.0, 9.0}) {
    ob::ScopedState<> start(space);
    start[0] = 1.0;
    start[1] = y;
    setup.addStartState(start);
  }
  std::atomic<int> given{0};
  auto goals = std::make_shared<ob::GoalLazySamples>(
      setup.getSpaceInformation(), [&given](const ob::GoalLazySamples*, ob::State* state) {
        const int i = given++;
        state->as<RealVector>()->values[0] = 9.0;
        state->as<RealVector>()->values[1] = i % 2 == 0 ? 1.0 + 0.01 * i : 5.0 + 0.01 * i;
        return i < 40;
      });
  setup.setGoal(goals);
  expectSolved(setup);
  goals->stopSampling();
  EXPECT_EQ(setup.getSolutionPath().getState(0)->as<RealVector>()->values[1], 5.0);
}

INSTANTIATE_TEST_SUITE_P(Planners, OmplProblem,
                         ::testing::Values(b4pCase(1, false), b4pCase(2, false), b4pCase(2, true),
                                           sharedCase(2), redirectableCase()),
                         caseName);

}  // namespace
}  // namespace b4p::test
