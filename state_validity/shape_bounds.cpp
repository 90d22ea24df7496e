// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/shape_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace b4p {
namespace {

struct BoundsOfShape {
  ShapeBounds operator()(const Box& box) const { return {Eigen::Vector3d::Zero(), 0.5 * box.size, 0.0}; }
  ShapeBounds operator()(const Sphere& sphere) const {
    return {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), sphere.radius};
  }
  ShapeBounds operator()(const Cylinder& cylinder) const {
    return {Eigen::Vector3d::Zero(), {cylinder.radius, cylinder.radius, 0.5 * cylinder.length}, 0.0};
  }
  ShapeBounds operator()(const Capsule& capsule) const {
    return {Eigen::Vector3d::Zero(), {0.0, 0.0, 0.5 * capsule.length}, capsule.radius};
  }
  ShapeBounds operator()(const std::shared_ptr<const ConvexMesh>& mesh) const {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& vertex : mesh->vertices) box.extend(vertex);
    return {box.center(), 0.5 * box.sizes(), 0.0};
  }
};

// Support functions: the largest p . u over the shape, u a unit vector in S.
struct SupportOfShape {
  Eigen::Vector3d u;

  double operator()(const Box& box) const { return 0.5 * box.size.dot(u.cwiseAbs()); }
  double operator()(const Sphere& sphere) const { return sphere.radius; }
  double operator()(const Cylinder& cylinder) const {
    return 0.5 * cylinder.length * std::abs(u.z()) + cylinder.radius * std::hypot(u.x(), u.y());
  }
  double operator()(const Capsule& capsule) const {
    return 0.5 * capsule.length * std::abs(u.z()) + capsule.radius;
  }
  double operator()(const std::shared_ptr<const ConvexMesh>& mesh) const {
    double support = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& vertex : mesh->vertices) support = std::max(support, vertex.dot(u));
    return support;
  }
};

}  // namespace

ShapeBounds boundsOf(const Shape& shape) { return std::visit(BoundsOfShape{}, shape); }

double extentAlong(const PlacedShape& placed, const Eigen::Vector3d& u_B) {
  const Eigen::Vector3d u_S = placed.X_BS.linear().transpose() * u_B;
  return placed.X_BS.translation().dot(u_B) + std::visit(SupportOfShape{u_S}, placed.shape);
}

}  // namespace b4p
