// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/ScopedState.h>

#include "planners/reach/reach_goal.h"
#include "planners/reach/reach_search.h"

namespace b4p {

/// Free goal configurations of a ReachGoal by inverse kinematics, for one search.
class GoalConfigurations {
 public:
  GoalConfigurations(const ompl::base::SpaceInformationPtr& si, const ReachGoal& goal, std::uint64_t seed,
                     ReachStatistics& statistics);

  /// One attempt at a grasp. A valid state, good until the next attempt, or nullptr.
  const ompl::base::State* attempt(GraspId grasp);

  std::mt19937_64& random() { return ik_.random(); }

 private:
  ompl::base::SpaceInformationPtr si_;
  const JointSpace& joints_;
  GraspIk ik_;
  ompl::base::ScopedState<> state_;
  ReachStatistics& statistics_;
};

}  // namespace b4p
