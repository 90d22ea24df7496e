// SPDX-License-Identifier: BSD-3-Clause
#include "planners/reach/goal_configurations.h"

namespace b4p {

namespace ob = ompl::base;

GoalConfigurations::GoalConfigurations(const ob::SpaceInformationPtr& si, const ReachGoal& goal,
                                       std::uint64_t seed, ReachStatistics& statistics)
    : si_(si),
      joints_(goal.joints()),
      ik_(goal.robot(), goal.targets(), goal.joints(), seed),
      state_(si),
      statistics_(statistics) {
  GraspAccess(si).set(state_.get(), kNoGrasp);
}

const ob::State* GoalConfigurations::attempt(GraspId grasp) {
  countOne(statistics_.ik_attempts);
  const bool found = ik_.attempt(grasp, joints_.q(state_.get())) && si_->isValid(state_.get());
  return found ? state_.get() : nullptr;
}

}  // namespace b4p
