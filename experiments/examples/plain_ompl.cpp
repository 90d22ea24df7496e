// SPDX-License-Identifier: BSD-3-Clause
// B4P in the place of any other OMPL planner: a point in the plane, two walls with gaps, several goals, no
// grasps.
#include <cmath>
#include <iostream>
#include <memory>

#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>

#include "planners/b4p/b4p_planner.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

bool isFree(const ob::State* state) {
  const double* p = state->as<ob::RealVectorStateSpace::StateType>()->values;
  const bool in_first_wall = std::abs(p[0] - 0.3) < 0.02 && p[1] < 0.9;
  const bool in_second_wall = std::abs(p[0] - 0.6) < 0.02 && p[1] > 0.1;
  return !in_first_wall && !in_second_wall;
}

}  // namespace

int main() {
  const auto space = std::make_shared<ob::RealVectorStateSpace>(2);
  space->setBounds(0.0, 1.0);
  og::SimpleSetup setup(space);
  setup.setStateValidityChecker(isFree);
  setup.getSpaceInformation()->setStateValidityCheckingResolution(0.002);

  ob::ScopedState<ob::RealVectorStateSpace> state(space);
  state->values[0] = 0.1;
  state->values[1] = 0.1;
  setup.addStartState(state);
  const auto goals = std::make_shared<ob::GoalStates>(setup.getSpaceInformation());
  for (const double y : {0.2, 0.5, 0.8}) {
    state->values[0] = 0.9;
    state->values[1] = y;
    goals->addState(state);
  }
  setup.setGoal(goals);

  const auto planner = std::make_shared<b4p::B4P>(setup.getSpaceInformation());
  planner->params()["threads"] = 2;
  setup.setPlanner(planner);
  const ob::PlannerStatus status = setup.solve(10.0);
  if (status != ob::PlannerStatus::EXACT_SOLUTION) return 1;
  setup.getSolutionPath().printAsMatrix(std::cout);
  return 0;
}
