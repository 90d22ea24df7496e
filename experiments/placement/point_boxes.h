// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "state_validity/collision_checker.h"

namespace b4p {

/// Boxes that together are exactly the cells, on a lattice with this origin and these cells in all
/// directions, that hold a point; in obstacles called `name`_0, `name`_1, ...
/// @throws InputError naming `name` when there are more than 20,000 boxes
std::vector<Obstacle> boxesAround(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& origin_m,
                                  double cell_m, const std::string& name);

}  // namespace b4p
