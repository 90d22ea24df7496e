// SPDX-License-Identifier: BSD-3-Clause
// Plans past a wall in the unit square. Ends with 0 when the path is exact and valid.
#include <memory>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>

#include "planners/b4p/b4p_planner.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

int main() {
  auto space = std::make_shared<ob::RealVectorStateSpace>(2);
  space->setBounds(0.0, 1.0);
  og::SimpleSetup setup(space);
  setup.setStateValidityChecker([](const ob::State* state) {
    const double* p = state->as<ob::RealVectorStateSpace::StateType>()->values;
    const bool in_wall = p[0] > 0.4 && p[0] < 0.6 && p[1] < 0.8;
    return !in_wall;
  });
  ob::ScopedState<> start(space), goal(space);
  start[0] = start[1] = goal[1] = 0.1;
  goal[0] = 0.9;
  setup.setStartAndGoalStates(start, goal);
  setup.setPlanner(std::make_shared<b4p::B4P>(setup.getSpaceInformation()));

  constexpr double kTimeLimit_s = 20.0;
  const bool exact = setup.solve(kTimeLimit_s) == ob::PlannerStatus::EXACT_SOLUTION;
  return exact && setup.getSolutionPath().check() ? 0 : 1;
}
