// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "experiments/placement/lattice.h"
#include "state_validity/collision_checker.h"

namespace b4p {

/// Points (m) of a PLY or PCD file in ASCII, told apart by its first word. Other properties than x, y and z
/// are skipped.
/// @throws InputError naming file, line and value: unreadable file, another format (binary among them),
///   malformed header, no points, fewer rows than the header says, a coordinate that is missing, no number,
///   not finite or farther than 1000 m
std::vector<Eigen::Vector3d> readPointCloud(const std::string& file);

/// Boxes that together are exactly the cells, on a lattice with this origin and these cells in all
/// directions, that hold a point; in obstacles called `name`_0, `name`_1, ...
/// @throws InputError naming `name` when there are more than 20,000 boxes
std::vector<Obstacle> boxesAround(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& origin_m,
                                  double cell_m, const std::string& name);

}  // namespace b4p
