// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "state_validity/shape_bounds.h"

namespace b4p {

/// A rounded box in the world.
struct PosedBounds {
  const ShapeBounds& bounds;
  const Eigen::Isometry3d& X_WS;
};

/// Lower bound (m) of the distance of two rounded boxes; negative if none was found. Found by a few steps
/// towards the closest points, given up as soon as the bound exceeds `enough_m`. Holds whatever the steps
/// did, for it is the width of the gap between two parallel planes.
double separation(const PosedBounds& a, const PosedBounds& b, double enough_m);

}  // namespace b4p
