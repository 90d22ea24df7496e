// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "experiments/verification/collision_sweep.h"
#include "experiments/verification/kinematics.h"
#include "robots/grasp.h"

namespace b4p::verification {

constexpr double kFinerThanPlanning = 10.0;  ///< by how much paths are checked at smaller steps

/// Pose of the held object at a way-point.
Eigen::Isometry3d objectPose(const Kinematics& robot, const Grasp& grasp, const std::vector<double>& row);

/// The first collision along a path, one line naming way-point or edge; or an empty string. A path of one
/// way-point is an edge from it to itself.
std::string motionProblem(const std::vector<std::vector<double>>& path, CollisionSweep& sweep);

}  // namespace b4p::verification
