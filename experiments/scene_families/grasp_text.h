// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

namespace b4p {

/// A table of grasps, as readGraspTable() reads it: poses of the TCP, one a line, each number rounded to
/// 1e-7.
std::string graspText(const std::vector<Eigen::Isometry3d>& poses);

}  // namespace b4p
