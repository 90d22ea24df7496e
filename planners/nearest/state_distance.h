// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <utility>

#include "planners/manipulation_state_space.h"

namespace b4p {

/// How far apart two states lie. Any thread may ask.
class StateDistance {
 public:
  using Function = std::function<double(const ompl::base::State*, const ompl::base::State*)>;

  template <class Callable, class = std::enable_if_t<std::is_constructible_v<Function, Callable> &&
                                                     !std::is_same_v<Callable, StateDistance>>>
  StateDistance(Callable function) : function_(std::move(function)) {}

  /// ManipulationStateSpace::jointDistance(). `space` outlives the object.
  static StateDistance ofJoints(const ManipulationStateSpace& space) {
    StateDistance distance([&space](const auto* a, const auto* b) { return space.jointDistance(a, b); });
    distance.joints_ = static_cast<int>(space.dof());
    return distance;
  }

  double operator()(const ompl::base::State* a, const ompl::base::State* b) const { return function_(a, b); }

  /// How many joint values of manipulation states it is the Euclidean distance of; 0 for any other distance.
  int joints() const { return joints_; }

 private:
  Function function_;
  int joints_ = 0;
};

}  // namespace b4p
