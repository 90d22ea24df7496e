// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "experiments/planners.h"
#include "planners/placement/placement_options.h"

namespace b4p {

/// The planner `placement`: PlacementPlanner, whose parameters hold the goal's options as well, by the names
/// that they have in PlacementOptions (`sampling` and `reward` are words).
/// @param options  what these parameters set; a goal made afterwards draws accordingly
PlannerKind placementPlannerKind(const std::shared_ptr<PlacementOptions>& options);

/// Ways of sampling by the names that commands and files have for them.
/// @throws InputError listing the names there are
PlacementSampling placementSampling(const std::string& name, const std::string& where);
std::string nameOf(PlacementSampling sampling);

}  // namespace b4p
