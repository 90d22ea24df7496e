// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "robots/manipulator.h"

namespace b4p {

/// Rigorous upper bounds of how far points of a robot travel.
///
/// Entry j (dof() of them): no point of `shape`, fixed to link `link` (pose X_BS in the link's frame), moves
/// more than this many metres when planned joint j turns by 1 rad (or slides by 1 m), whatever the other
/// joints' values inside their limits and the gripper's opening. For a revolute joint that is the shape's
/// largest distance from the axis; 1 for a prismatic joint; 0 for a joint that does not carry the link. Along
/// a straight joint edge a point therefore travels at most sum_j travel_j |dq_j|.
Eigen::VectorXd travelPerUnit(const Manipulator& robot, int link, const PlacedShape& shape);

}  // namespace b4p
