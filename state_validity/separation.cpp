// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/separation.h"

#include <algorithm>

namespace b4p {
namespace {

// More steps find few gaps that these miss; an exact check follows anyway.
constexpr int kSteps = 8;
// Boxes closer than this overlap as far as this bound is concerned.
constexpr double kTouching_m = 1e-6;

// The point of the box (without its rounding) that lies farthest in direction u.
Eigen::Vector3d farthestPoint(const PosedBounds& box, const Eigen::Vector3d& u_W) {
  const Eigen::Vector3d u_S = box.X_WS.linear().transpose() * u_W;
  const Eigen::Vector3d& half = box.bounds.half;
  const Eigen::Vector3d corner(u_S.x() < 0.0 ? -half.x() : half.x(), u_S.y() < 0.0 ? -half.y() : half.y(),
                               u_S.z() < 0.0 ? -half.z() : half.z());
  return box.X_WS * (box.bounds.centre + corner);
}

}  // namespace

double separation(const PosedBounds& a, const PosedBounds& b, double enough_m) {
  // Gilbert's method: `way` leads from a point of a to a point of b and shrinks towards the shortest one. The
  // planes across it through the points nearest to each other bound the distance from below.
  const double rounding_m = a.bounds.radius + b.bounds.radius;
  double best_m = -rounding_m;
  Eigen::Vector3d way = b.X_WS * b.bounds.centre - a.X_WS * a.bounds.centre;
  for (int step = 0; step < kSteps; ++step) {
    const double length_m = way.norm();
    if (length_m < kTouching_m) break;
    const Eigen::Vector3d corner_way = farthestPoint(b, -way) - farthestPoint(a, way);
    const double gap_m = way.dot(corner_way) / length_m;
    best_m = std::max(best_m, gap_m - rounding_m);
    if (best_m > enough_m || length_m - gap_m < kTouching_m || length_m < rounding_m) break;
    // The point nearest to the origin between the old way and the new one.
    const Eigen::Vector3d change = corner_way - way;
    const double share = std::clamp(-way.dot(change) / change.squaredNorm(), 0.0, 1.0);
    way += share * change;
  }
  return best_m;
}

}  // namespace b4p
