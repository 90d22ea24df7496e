// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>

#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Console.h>

#include "planners/nearest/state_distance.h"

namespace b4p::test {

/// A field of 10 x 10 in which points move; OMPL is told to be silent.
struct Field {
  using Point = ompl::base::RealVectorStateSpace::StateType;

  Field() {
    ompl::msg::noOutputHandler();
    auto space = std::make_shared<ompl::base::RealVectorStateSpace>(2);
    space->setBounds(0.0, 10.0);
    si = std::make_shared<ompl::base::SpaceInformation>(space);
    si->setStateValidityChecker([this](const ompl::base::State* s) { return is_valid(x(s), y(s)); });
    si->setStateValidityCheckingResolution(0.001);
    si->setup();
  }
  Field(const Field&) = delete;
  Field& operator=(const Field&) = delete;

  static double x(const ompl::base::State* s) { return s->as<Point>()->values[0]; }
  static double y(const ompl::base::State* s) { return s->as<Point>()->values[1]; }
  static bool isAt(const ompl::base::State* s, double px, double py) { return x(s) == px && y(s) == py; }

  ompl::base::ScopedState<> at(double px, double py) const {
    ompl::base::ScopedState<> state(si);
    state[0] = px;
    state[1] = py;
    return state;
  }

  StateDistance distance() const {
    return [space = si->getStateSpace()](const ompl::base::State* a, const ompl::base::State* b) {
      return space->distance(a, b);
    };
  }

  std::function<bool(double, double)> is_valid = [](double, double) { return true; };
  ompl::base::SpaceInformationPtr si;
};

}  // namespace b4p::test
