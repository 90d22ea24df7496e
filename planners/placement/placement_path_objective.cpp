// SPDX-License-Identifier: BSD-3-Clause
#include "planners/placement/placement_path_objective.h"

#include <limits>
#include <utility>

namespace b4p {

namespace ob = ompl::base;

PlacementPathObjective::PlacementPathObjective(const ob::SpaceInformationPtr& si,
                                               std::shared_ptr<const PlacementGoal> goal)
    : ob::OptimizationObjective(si), goal_(std::move(goal)) {
  description_ = "objective of the placement";
  threshold_ = ob::Cost(std::numeric_limits<double>::infinity());  // no value is good enough to stop at
}

ob::Cost PlacementPathObjective::stateCost(const ob::State*) const { return identityCost(); }

ob::Cost PlacementPathObjective::motionCost(const ob::State*, const ob::State*) const {
  return identityCost();
}

ob::Cost PlacementPathObjective::terminalCost(const ob::State* state) const {
  return ob::Cost(goal_->objective(state));
}

ob::Cost PlacementPathObjective::infiniteCost() const {
  return ob::Cost(-std::numeric_limits<double>::infinity());
}

bool PlacementPathObjective::isCostBetterThan(ob::Cost a, ob::Cost b) const { return a.value() > b.value(); }

}  // namespace b4p
