// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "robots/shape.h"
#include "state_validity/collision_checker.h"

namespace b4p {

/// What has to be reached, and what stands around it, in the world: z = 0 is the floor.
struct ConfinedScenario {
  std::vector<Obstacle> obstacles;  ///< the floor first; without the target
  std::vector<PlacedShape> target;  ///< convex pieces, which may overlap
  double support_height_m = 0.0;    ///< of the plane that the target lies on
};

/// The places of the Jogramop framework (Rudorfer, Hartvich, Vonasek, RoMoCo 2024), from their dimensions.
/// @param group  1: screwdriver on a table, inside an open shelf; 2: ball on the floor under a table; 3: box
/// on
///   the floor behind a gap between two walls; 4: banana on a pedestal behind a gate
/// @param step  1 (easy) to 5: farther inside for groups 1 and 2, a narrower opening for 3 and 4
ConfinedScenario confinedScenario(int group, double step);

/// Root link of the mobile Panda in the world.
Eigen::Isometry3d confinedRobotBase();

}  // namespace b4p
