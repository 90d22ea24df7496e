// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

namespace b4p {

/// Bring the empty hand, fingers fully open, from a configuration to one of several grasps. The object to be
/// grasped is an obstacle like any other.
struct ReachTask {
  std::vector<double> start;  ///< rad or m, in the robot file's order of joints
  /// Poses of the TCP in the world W; their rotations mean nothing where the orientation is free.
  std::vector<Eigen::Isometry3d> X_WT;
  bool orientation_free = false;
  std::string grasp_file;  ///< where the poses come from, row by row; "" for positions in the scene file
  double position_tolerance_m = 1e-3;
  double angle_tolerance_rad = 0.00873;
  bool flip = true;  ///< the grasp turned by 180 degrees about its approach axis z is the same one
};

}  // namespace b4p
