// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "experiments/scene.h"
#include "robots/manipulator.h"
#include "state_validity/collision_checker.h"

namespace b4p {

// What makes a reaching task hopeless. Each throws InputError naming element and value.

/// @throws InputError for the first joint outside its limits
void requireStartInsideLimits(const Scene& scene, const ReachTask& task, const Manipulator& robot);

/// @throws InputError for a start in which links touch each other or an obstacle, or come nearer than half of
///   edge_step_m
void requireFreeStart(const Scene& scene, const ReachTask& task, const CollisionChecker& checker);

/// @throws InputError for the first grasp farther from the robot's root than the arm is long at most
void requireGraspsWithinReach(const Scene& scene, const ReachTask& task, const Manipulator& robot);

}  // namespace b4p
