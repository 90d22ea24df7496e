// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/certification/planar/convex_polygon.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace b4p::planar {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Appends the points to a chain that only turns left.
void extend(Polygon& chain, const Eigen::Vector2d& point, std::size_t fixed) {
  while (chain.size() > fixed &&
         cross(chain.back() - chain[chain.size() - 2], point - chain[chain.size() - 2]) <= 0.0)
    chain.pop_back();
  chain.push_back(point);
}

}  // namespace

Polygon convexHull(std::vector<Eigen::Vector2d> points) {
  const auto before = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Polygon hull;
  for (const Eigen::Vector2d& point : points) extend(hull, point, 1);
  const std::size_t lower = hull.size();
  for (auto point = points.rbegin() + 1; point != points.rend(); ++point) extend(hull, *point, lower);
  hull.pop_back();
  return hull;
}

Polygon turned(const Polygon& polygon, double angle_rad) {
  const Eigen::Rotation2Dd rotation(angle_rad);
  Polygon result;
  for (const Eigen::Vector2d& corner : polygon) result.push_back(rotation * corner);
  return result;
}

Polygon overlapPositions(const Polygon& fixed, const Polygon& moving) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(fixed.size() * moving.size());
  for (const Eigen::Vector2d& w : fixed)
    for (const Eigen::Vector2d& m : moving) points.push_back(w - m);
  return convexHull(std::move(points));
}

std::vector<HalfPlane> eroded(const Polygon& polygon, double half_square_m, double disc_m) {
  std::vector<HalfPlane> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& corner = polygon[i];
    const Eigen::Vector2d along = (polygon[(i + 1) % polygon.size()] - corner).normalized();
    const Eigen::Vector2d normal(along.y(), -along.x());
    result.push_back({normal, normal.dot(corner) - half_square_m * normal.lpNorm<1>() - disc_m});
  }
  return result;
}

double farthestCorner(const Polygon& polygon) {
  double farthest = 0.0;
  for (const Eigen::Vector2d& corner : polygon) farthest = std::max(farthest, corner.norm());
  return farthest;
}

}  // namespace b4p::planar
