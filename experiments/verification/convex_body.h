// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "robots/shape.h"

namespace b4p::verification {

/// A convex solid as its support function sees it: a core grown by a margin in all directions. Lengths in
/// metres, in the solid's own frame S. Immutable; any thread may use it.
class ConvexBody {
 public:
  static ConvexBody box(const Eigen::Vector3d& size);
  static ConvexBody sphere(double radius);
  static ConvexBody cylinder(double radius, double length);     ///< along z, between the flat ends
  static ConvexBody capsule(double radius, double length);      ///< along z, between the centres of its ends
  static ConvexBody hull(std::vector<Eigen::Vector3d> points);  ///< at least one point
  static ConvexBody of(const Shape& shape);

  /// The core's point farthest along `direction` (any length but zero).
  Eigen::Vector3d support(const Eigen::Vector3d& direction) const;

  double margin() const { return margin_; }

  /// A ball around everything, margin included.
  const Eigen::Vector3d& centre() const { return centre_; }
  double radius() const { return radius_; }

 private:
  enum class Core { kBox, kCylinder, kPoints };

  Core core_ = Core::kBox;
  Eigen::Vector3d half_ =
      Eigen::Vector3d::Zero();  ///< kBox: half sides; kCylinder: (radius, radius, half length)
  std::vector<Eigen::Vector3d> points_;
  double margin_ = 0.0;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  double radius_ = 0.0;
};

/// A body fixed in the frame of a link, of the object or of the world.
struct PlacedBody {
  ConvexBody body;
  Eigen::Isometry3d X_LS = Eigen::Isometry3d::Identity();
};

}  // namespace b4p::verification
