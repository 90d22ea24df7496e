// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "robots/manipulator.h"

namespace b4p {

/// Index of model joint `joint` in q, or -1 if it is not planned.
int plannedIndex(const Manipulator& robot, int joint);

/// True for the joints that the gripper's opening sets.
bool isFingerJoint(const Manipulator& robot, int joint);

/// Planned joints (indices into q) that carry the link.
std::vector<int> planningJointsAbove(const Manipulator& robot, int link);

/// True when a planned joint or a finger joint moves the link.
bool isMoving(const Manipulator& robot, int link);

/// True for two links that never count as colliding: nothing planned moves one relative to the other,
/// they are joined by one joint (whatever is fixed to either included), or the robot's description says so.
bool mayTouch(const Manipulator& robot, int link_a, int link_b);

}  // namespace b4p
