// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "experiments/scene.h"
#include "robots/manipulator.h"
#include "state_validity/collision_checker.h"

namespace b4p {

// While one arm of a placement scene moves, the others rest at their starts, with nothing in their hands and
// their fingers at `rest_opening_m`. Arms of one URDF at one base are chains of one robot: the others are
// then links of the robot that moves, at rest. A joint that two chains share belongs to the one that moves.

/// The robot of an arm, ready to move it, the robot's other arms at rest.
/// @param arm  index in the task's list
/// @throws InputError when robot or URDF are at fault, or the start of another arm is out of its limits or
///   contradicts that of a third one with which it shares joints
std::shared_ptr<const Manipulator> robotWithOthersAtRest(const Scene& scene, std::size_t arm);

/// The links of all other robots, named ARM: LINK.
/// @throws InputError as robotWithOthersAtRest() does
std::vector<Obstacle> otherRobots(const Scene& scene, std::size_t arm);

}  // namespace b4p
