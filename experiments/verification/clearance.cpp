// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/verification/clearance.h"

#include <algorithm>
#include <cmath>

#include "experiments/verification/separation.h"

namespace b4p::verification {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

bool apart(const ConvexBody& a, const Isometry3d& X_WA, const ConvexBody& b, const Isometry3d& X_WB) {
  return separation(a, X_WA, b, X_WB, Vector3d::UnitX()).apart();
}

double top_m(const PlacedBody& obstacle) {
  const Vector3d up = obstacle.X_LS.linear().transpose() * Vector3d::UnitZ();
  return (obstacle.X_LS * obstacle.body.support(up)).z() + obstacle.body.margin();
}

/// Centres of the cubes of a lattice around the object that any of its shapes overlaps; of many, evenly
/// chosen ones, few enough to be measured one by one.
std::vector<Vector3d> pointsOf(const std::vector<PlacedShape>& shapes, double cell_m) {
  constexpr std::size_t kMost = 1500;
  constexpr double kRounding_m = 1e-6;
  Vector3d low = Vector3d::Constant(1e9), high = -low;
  std::vector<PlacedBody> bodies;
  for (const PlacedShape& shape : shapes) {
    bodies.push_back({ConvexBody::of(shape.shape), shape.X_BS});
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {-1.0, 1.0}) {
        const Vector3d direction = sign * Vector3d::Unit(axis);
        const Vector3d end =
            shape.X_BS * bodies.back().body.support(shape.X_BS.linear().transpose() * direction) +
            bodies.back().body.margin() * direction;
        low = low.cwiseMin(end);
        high = high.cwiseMax(end);
      }
  }
  const Eigen::Array3i count =
      ((high - low).array() / cell_m - kRounding_m / cell_m).ceil().cast<int>().max(1);
  const Vector3d first = 0.5 * (low + high) - 0.5 * cell_m * (count - 1).cast<double>().matrix();
  const ConvexBody cube = ConvexBody::box(Vector3d::Constant(cell_m - 2.0 * kRounding_m));
  std::vector<Vector3d> points;
  for (int i = 0; i < count.x(); ++i)
    for (int j = 0; j < count.y(); ++j)
      for (int k = 0; k < count.z(); ++k) {
        const Vector3d p = first + cell_m * Vector3d(i, j, k);
        if (std::any_of(bodies.begin(), bodies.end(), [&](const PlacedBody& body) {
              return !apart(cube, Isometry3d(Eigen::Translation3d(p)), body.body, body.X_LS);
            }))
          points.push_back(p);
      }
  if (points.size() <= kMost) return points;
  std::vector<Vector3d> chosen;
  for (std::size_t i = 0; i < kMost; ++i) chosen.push_back(points[i * points.size() / kMost]);
  return chosen;
}

/// Spread over the upper half of the unit ball, its equator included.
std::vector<Vector3d> upperDirections() {
  constexpr int kEquator = 48, kAbove = 150;
  const double turn_rad = 2.0 * std::acos(-1.0), golden_rad = std::acos(-1.0) * (3.0 - std::sqrt(5.0));
  std::vector<Vector3d> directions;
  for (int i = 0; i < kEquator; ++i)
    directions.emplace_back(std::cos(turn_rad * i / kEquator), std::sin(turn_rad * i / kEquator), 0.0);
  for (int i = 0; i < kAbove; ++i) {
    const double z = (i + 0.5) / kAbove, r = std::sqrt(1.0 - z * z);
    directions.emplace_back(r * std::cos(golden_rad * i), r * std::sin(golden_rad * i), z);
  }
  return directions;
}

}  // namespace

Clearance::Clearance(const Scene& scene)
    : task_(scene.placing()),
      points_O_(pointsOf(scene.placing().object, scene.placing().cell_m)),
      directions_(upperDirections()) {
  const ConvexBody volume = ConvexBody::box(task_.max_m - task_.min_m);
  const Isometry3d X_WV(Eigen::Translation3d(0.5 * (task_.min_m + task_.max_m)));
  for (const Obstacle& obstacle : scene.obstacles) {
    const PlacedBody body{ConvexBody::of(obstacle.shape.shape), obstacle.shape.X_BS};
    if (!apart(body.body, body.X_LS, volume, X_WV)) obstacles_.push_back(body);
  }
}

bool Clearance::counts(const Vector3d& point_W, double lowest_m) const {
  constexpr double kSlack_m = 1e-4;
  return point_W.z() >= lowest_m - kSlack_m && (point_W.array() >= task_.min_m.array() - kSlack_m).all() &&
         (point_W.array() <= task_.max_m.array() + kSlack_m).all();
}

// The part of the ball that lies no lower than the point and inside the volume.
bool Clearance::touches(const PlacedBody& obstacle, const Vector3d& p_W, double radius_m) const {
  std::vector<Vector3d> corners{p_W};
  for (const Vector3d& direction : directions_) {
    double length = radius_m;
    for (int axis = 0; axis < 3; ++axis) {
      if (direction[axis] == 0.0) continue;
      const double wall = direction[axis] > 0.0 ? task_.max_m[axis] : task_.min_m[axis];
      length = std::min(length, std::max(0.0, (wall - p_W[axis]) / direction[axis]));
    }
    corners.push_back(p_W + length * direction);
  }
  return !apart(ConvexBody::hull(std::move(corners)), Isometry3d::Identity(), obstacle.body, obstacle.X_LS);
}

double Clearance::at(const Vector3d& p_W) const {
  constexpr double kResolution_m = 2e-4;
  const Vector3d half_cell = Vector3d::Constant(0.5 * task_.cell_m);
  const Vector3d p = p_W.cwiseMax(task_.min_m + half_cell).cwiseMin(task_.max_m - half_cell);
  const double lowest_m = p.z() - 0.5 * task_.cell_m;  // of what counts as not lower
  const ConvexBody point = ConvexBody::hull({p});
  double nearest = (task_.max_m - task_.min_m).norm();
  for (const PlacedBody& obstacle : obstacles_) {
    const Vector3d centre = obstacle.X_LS * obstacle.body.centre();
    if ((p - centre).norm() - obstacle.body.radius() >= nearest || top_m(obstacle) < lowest_m) continue;
    const Separation gap = separation(point, Isometry3d::Identity(), obstacle.body, obstacle.X_LS,
                                      p - centre + 1e-6 * Vector3d::Ones());
    double low = std::max(0.0, gap.distance_m);
    if (low >= nearest) continue;
    if (counts(p - low * gap.direction, lowest_m)) {
      nearest = low;
      continue;
    }
    if (!touches(obstacle, p, nearest)) continue;
    while (nearest - low > kResolution_m) {
      const double middle = 0.5 * (low + nearest);
      (touches(obstacle, p, middle) ? nearest : low) = middle;
    }
  }
  return nearest;
}

double Clearance::mean_m(const Isometry3d& X_WO) const {
  double sum = 0.0;
  for (const Vector3d& p_O : points_O_) sum += at(X_WO * p_O);
  return sum / static_cast<double>(points_O_.size());
}

}  // namespace b4p::verification
