// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <variant>

#include <Eigen/Core>

#include "robots/shape.h"

namespace b4p {

/// The surface of a box, sphere, cylinder or capsule, in the frame of the body B that carries it. Immutable.
class Surface {
 public:
  /// @throws std::invalid_argument for a mesh
  explicit Surface(const PlacedShape& placed);

  double area_m2() const { return area_m2_; }

  /// A point of the surface, uniform by area.
  Eigen::Vector3d sample(std::mt19937_64& random) const;

  /// Distance of a point from the surface (m), negative inside.
  double signedDistance(const Eigen::Vector3d& p_B) const;

  /// The outward unit normal at a point of the surface; that of a neighbouring face on an edge.
  Eigen::Vector3d normal(const Eigen::Vector3d& p_B) const;

  /// Where a ray from a point of the surface into the shape comes out again, to 1e-12 m.
  Eigen::Vector3d exit(const Eigen::Vector3d& p_B, const Eigen::Vector3d& direction_B) const;

 private:
  using Primitive = std::variant<Box, Sphere, Cylinder, Capsule>;
  static Primitive primitive(const Shape& shape);

  Primitive shape_;
  Eigen::Isometry3d X_BS_;
  Eigen::Isometry3d X_SB_;
  double area_m2_;
  double diameter_m_;  ///< upper bound
};

}  // namespace b4p
