// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "experiments/scene_families/jitter.h"

namespace b4p {

using Outline = std::vector<Eigen::Vector2d>;  ///< counter-clockwise, in the object's frame, m

/// The 21-gon of the maze that ships.
Outline standardOutline();

/// A star-shaped 21-gon about 0.6 m x 0.28 m around the origin, corners in millimetres. Of a number of draws,
/// the one whose slimmest grasp is slimmer than its second slimmest by most.
Outline drawnOutline(Jitter& jitter);

/// The narrowest straight corridor (m) that the planar gripper and the object pass when it holds each edge,
/// clearance `clearance_m` between gripper and edge: the least width of their convex hull.
std::vector<double> graspWidths(const Outline& outline, double clearance_m);

/// Cuts a polygon that is star-shaped about the origin into convex sectors, each beginning at the origin.
std::vector<Outline> convexSectors(const Outline& outline);

}  // namespace b4p
