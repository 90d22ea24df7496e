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

/// A box in any orientation, rounded by a ball.
struct RoundedBox {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix3d half_axes =
      Eigen::Matrix3d::Zero();  ///< columns: from the centre to the middles of three faces
  double radius = 0.0;          ///< of the ball (m)

  Aabb aabb() const {
    return {centre, half_axes.cwiseAbs().rowwise().sum() + Eigen::Vector3d::Constant(radius)};
  }
};

/// A rounded box along the axes of the shape's frame S that contains the shape: loose for meshes and sideways
/// for cylinders, exact otherwise.
struct ShapeBounds {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of the box, in S
  Eigen::Vector3d half = Eigen::Vector3d::Zero();    ///< half side lengths of the box (m)
  double radius = 0.0;                               ///< of the ball (m)

  RoundedBox posed(const Eigen::Isometry3d& X_WS) const {
    return {X_WS * centre, X_WS.linear() * half.asDiagonal(), radius};
  }
};

ShapeBounds boundsOf(const Shape& shape);

/// Largest value (m) of p . u over all points p of the shape, p and the unit vector u in B. Exact.
double extentAlong(const PlacedShape& placed, const Eigen::Vector3d& u_B);

}  // namespace b4p
