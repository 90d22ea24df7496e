// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/separation.h"

#include <algorithm>

namespace b4p {
namespace {

// More steps find few gaps that these miss; an exact check follows anyway.
constexpr int kSteps = 8;
// Boxes closer than this overlap as far as this bound is concerned.
constexpr double kTouching_m = 1e-6;

// From the box's centre to the corner (its rounding left out) that lies farthest in direction u.
Eigen::Vector3d farthestCorner(const RoundedBox& box, const Eigen::Vector3d& u) {
  Eigen::Vector3d corner = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const auto axis = box.half_axes.col(i);
    if (axis.dot(u) < 0.0) {
      corner -= axis;
    } else {
      corner += axis;
    }
  }
  return corner;
}

}  // namespace

double separation(const RoundedBox& a, const RoundedBox& b, double known_m, double clear_m, double enough_m) {
  // Gilbert's method: `way` leads from a point of a to a point of b and shrinks towards the shortest one. The
  // planes across it through the points nearest to each other bound the distance from below.
  const double rounding_m = a.radius + b.radius;
  double best_m = known_m;
  const Eigen::Vector3d centre_way = b.centre - a.centre;
  Eigen::Vector3d way = centre_way;
  for (int step = 0; step < kSteps; ++step) {
    const double length_m = way.norm();
    if (length_m < std::max(kTouching_m, rounding_m)) break;
    if (best_m > clear_m && length_m - rounding_m <= enough_m) break;
    const Eigen::Vector3d corner_way = centre_way - farthestCorner(b, way) - farthestCorner(a, way);
    const double gap_m = way.dot(corner_way) / length_m;
    best_m = std::max(best_m, gap_m - rounding_m);
    if (best_m > enough_m || length_m - gap_m < kTouching_m) break;
    // The point nearest to the origin between the old way and the new one.
    const Eigen::Vector3d change = corner_way - way;
    const double share = std::clamp(-way.dot(change) / change.squaredNorm(), 0.0, 1.0);
    way += share * change;
  }
  return best_m;
}

}  // namespace b4p
