// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "robots/shape.h"

namespace b4p {

/// An axis-aligned box in some frame.
struct Aabb {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d half = Eigen::Vector3d::Zero();  ///< half side lengths (m)

  /// Distance (m) between two boxes given in the same frame; 0 when they overlap or touch.
  double gapTo(const Aabb& other) const {
    const Eigen::Vector3d gap = (centre - other.centre).cwiseAbs() - half - other.half;
    return gap.cwiseMax(0.0).norm();
  }

  bool overlaps(const Aabb& other) const {
    return ((centre - other.centre).cwiseAbs() - half - other.half).maxCoeff() <= 0.0;
  }
};

/// A box in the shape's frame S, rounded by a ball, that contains the shape: loose for meshes and sideways
/// for cylinders, exact otherwise. Turns into an axis-aligned box of another frame without asking for the
/// shape's type.
struct ShapeBounds {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of the box, in S
  Eigen::Vector3d half = Eigen::Vector3d::Zero();    ///< half side lengths of the box (m)
  double radius = 0.0;                               ///< of the ball (m)

  Aabb aabb(const Eigen::Isometry3d& X_WS) const {
    return {X_WS * centre, X_WS.linear().cwiseAbs() * half + Eigen::Vector3d::Constant(radius)};
  }
};

ShapeBounds boundsOf(const Shape& shape);

/// Largest value (m) of p . u over all points p of the shape, p and the unit vector u in B. Exact.
double extentAlong(const PlacedShape& placed, const Eigen::Vector3d& u_B);

}  // namespace b4p
