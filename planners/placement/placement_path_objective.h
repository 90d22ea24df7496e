// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include <ompl/base/OptimizationObjective.h>

#include "planners/placement/placement_goal.h"

namespace b4p {

/// OMPL's view: a path costs what its last state is worth, and more is better.
class PlacementPathObjective : public ompl::base::OptimizationObjective {
 public:
  PlacementPathObjective(const ompl::base::SpaceInformationPtr& si,
                         std::shared_ptr<const PlacementGoal> goal);

  ompl::base::Cost stateCost(const ompl::base::State* state) const override;
  ompl::base::Cost motionCost(const ompl::base::State* from, const ompl::base::State* to) const override;
  ompl::base::Cost terminalCost(const ompl::base::State* state) const override;
  ompl::base::Cost infiniteCost() const override;
  bool isCostBetterThan(ompl::base::Cost a, ompl::base::Cost b) const override;

 private:
  std::shared_ptr<const PlacementGoal> goal_;
};

}  // namespace b4p
