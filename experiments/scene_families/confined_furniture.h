// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "state_validity/collision_checker.h"

namespace b4p {

// The furniture of the Jogramop framework's scenarios (Rudorfer, Hartvich, Vonasek, RoMoCo 2024) as boxes, in
// its own frame: the corner that is lowest along each axis is the origin, z points up.

std::vector<Obstacle> tableBoxes();                 ///< 2.0 x 0.8 x 0.5 m, on two legs
std::vector<Obstacle> openShelfBoxes();             ///< 0.46 x 0.5 x 0.4 m, open in front, behind, below
std::vector<Obstacle> gateBoxes(double opening_m);  ///< 2.0 m wide; the opening is square
std::vector<Obstacle> wallBoxes(const std::string& name);  ///< 0.8 x 0.1 x 1.0 m
std::vector<Obstacle> pedestalBoxes();                     ///< 0.4 x 0.4 x 0.5 m

/// The box between two corners (m), along the axes.
Obstacle boxObstacle(const std::string& name, const Eigen::Vector3d& low, const Eigen::Vector3d& high);

}  // namespace b4p
