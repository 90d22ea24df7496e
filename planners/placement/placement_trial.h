// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planners/placement/placement_sampler.h"

namespace b4p {

/// Tests one placement: the cheap tests of its pose first, inverse kinematics and the arm's collisions last
/// (paper, Algorithm 2, lines 5 to 7).
/// @param seed  all that inverse kinematics leaves to chance depends on it
/// @param q     a configuration that holds the object there, when the outcome is valid()
PlacementOutcome tryPlacement(const PlacementWorld& world, const PlacementObjective& objective,
                              const PlacementOptions& options, PlacementContext& context,
                              const Placement& placement, double threshold, std::uint64_t seed, double* q);

/// Counts an outcome under the first test it failed.
void countOutcome(const PlacementOutcome& outcome, const PlacementOptions& options,
                  PlacementStatistics& statistics);

}  // namespace b4p
