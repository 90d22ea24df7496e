// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/certification/planar/shape_slice.h"

#include <cmath>

#include "experiments/certification/planar/se2_grid.h"

namespace b4p::planar {
namespace {

constexpr int kSides = 32;  ///< of the polygons and rings that stand for circles
constexpr int kRings = 16;  ///< of a sphere, poles included

using Points = std::vector<Eigen::Vector3d>;

void addRing(double radius, double z, Points& points) {
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2.0 * kPi * i / kSides;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
}

void addSphere(double radius, double z, Points& points) {
  for (int ring = 0; ring <= kRings; ++ring) {
    const double latitude = kPi * (static_cast<double>(ring) / kRings - 0.5);
    addRing(radius * std::cos(latitude), z + radius * std::sin(latitude), points);
  }
}

struct InnerPoints {
  Points operator()(const Box& box) const {
    Points points;
    for (int corner = 0; corner < 8; ++corner)
      points.emplace_back(box.size.cwiseProduct(
          Eigen::Vector3d(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5)));
    return points;
  }
  Points operator()(const Sphere& sphere) const {
    Points points;
    addSphere(sphere.radius, 0.0, points);
    return points;
  }
  Points operator()(const Cylinder& cylinder) const {
    Points points;
    for (const double side : {-0.5, 0.5}) addRing(cylinder.radius, side * cylinder.length, points);
    return points;
  }
  Points operator()(const Capsule& capsule) const {
    Points points;
    for (const double side : {-0.5, 0.5}) addSphere(capsule.radius, side * capsule.length, points);
    return points;
  }
  Points operator()(const std::shared_ptr<const ConvexMesh>& mesh) const { return mesh->vertices; }
};

}  // namespace

Points innerPoints(const Shape& shape) { return std::visit(InnerPoints(), shape); }

Polygon cutAt(const Points& points, double z) {
  Points above, below;
  for (const Eigen::Vector3d& point : points) (point.z() >= z ? above : below).push_back(point);
  std::vector<Eigen::Vector2d> cut;
  // The hull's edges are among the segments between points, and all segments lie in the hull.
  for (const Eigen::Vector3d& a : above)
    for (const Eigen::Vector3d& b : below) {
      const double share = (a.z() - z) / (a.z() - b.z());
      cut.emplace_back((a + share * (b - a)).head<2>());
    }
  return convexHull(std::move(cut));
}

}  // namespace b4p::planar
