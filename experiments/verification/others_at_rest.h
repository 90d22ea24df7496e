// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "experiments/placement/placement_task.h"
#include "experiments/verification/collision_sweep.h"
#include "robots/manipulator.h"

namespace b4p::verification {

// While one arm of a placement task moves, the others stand at their starts, nothing in their hands. Those
// that have its URDF and its base are parts of its robot.

/// How the arm's robot is used, joints of the other arms at rest.
/// @param arm  index in the task's list
ManipulatorDescription withOthersAtRest(const PlacementTask& task, std::size_t arm);

/// The links of all arms that are no part of the arm's robot, where they stand.
/// @throws InputError when their files are at fault
std::vector<StandingBody> otherRobots(const PlacementTask& task, std::size_t arm);

}  // namespace b4p::verification
