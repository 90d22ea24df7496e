// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "experiments/certification/planar/blocked_proof.h"
#include "experiments/scene.h"
#include "robots/grasp.h"
#include "robots/manipulator.h"

namespace b4p::planar {

/// "" when the robot's planned joints are two that slide level and one behind them that turns about the
/// vertical; otherwise what is different.
std::string whyNotPlanar(const Manipulator& robot);

/// A scene under one grasp as motion in the plane of what the last joint carries, object included, at true
/// size. Body frame: origin on the axis of the turning joint, axes along the world's at angle 0, where
/// that joint is at 0.
///
/// Everything is cut at the heights at which both body and obstacles have an area, so overlapping slices are
/// collisions, of slightly smaller shapes where they are round. Not in it, and so never a reason to call
/// a pose blocked: links that the turning joint does not carry, contact of the robot with itself or the
/// object, the limits of the turning joint, and height and tilt of the placement. Start and goal are larger
/// by what the verifier tolerates.
///
/// @param robot  planar
/// @throws std::invalid_argument when the grasp cannot be reached at the start pose by motion in the plane
PlanarTask planarTask(const Scene& scene, const Manipulator& robot, const Grasp& grasp);

}  // namespace b4p::planar
