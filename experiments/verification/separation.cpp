// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/verification/separation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace b4p::verification {
namespace {

using Eigen::Vector3d;

constexpr int kMostIterations = 200;
constexpr double kRelativeAccuracy = 1e-8;
constexpr double kAbsoluteAccuracy_m = 1e-11;
constexpr double kFlat = 1e-12;  ///< volume of a tetrahedron without an inside, in cubes of its longest side

/// Points of the Minkowski difference, oldest first, and the point of their hull that is nearest to the
/// origin.
class Simplex {
 public:
  /// Adds a point and drops those that the nearest point does not need. That point lies on a face
  /// of the newest one, else the iteration has converged.
  void add(const Vector3d& point) {
    newest_ = point;
    best_norm_ = std::numeric_limits<double>::infinity();
    const int others = size_;
    for (int mask = 0; mask < (1 << others); ++mask) tryFace(mask, others);
    int kept = 0;
    for (int i = 0; i < others; ++i)
      if ((best_mask_ >> i & 1) != 0) points_[kept++] = points_[i];
    points_[kept++] = newest_;
    size_ = kept;
  }

  const Vector3d& nearest() const { return nearest_; }

 private:
  void offer(const Vector3d& foot, int mask) {
    const double norm = foot.norm();
    if (!(norm < best_norm_)) return;
    best_norm_ = norm;
    nearest_ = foot;
    best_mask_ = mask;
  }

  /// Offers the foot of the perpendicular from the origin onto the face of the newest point and the masked
  /// ones, where it falls inside that face.
  void tryFace(int mask, int others) {
    std::array<const Vector3d*, 3> corners{};
    int count = 0;
    for (int i = 0; i < others; ++i)
      if ((mask >> i & 1) != 0) corners[count++] = &points_[i];
    switch (count) {
      case 0:
        offer(newest_, mask);
        break;
      case 1:
        trySegment(*corners[0], mask);
        break;
      case 2:
        tryTriangle(*corners[0], *corners[1], mask);
        break;
      default:
        tryTetrahedron(*corners[0], *corners[1], *corners[2], mask);
    }
  }

  void trySegment(const Vector3d& a, int mask) {
    const Vector3d side = a - newest_;
    const double t = -newest_.dot(side) / side.squaredNorm();  // not a number for a = newest: not offered
    if (t >= 0.0 && t <= 1.0) offer(newest_ + t * side, mask);
  }

  void tryTriangle(const Vector3d& a, const Vector3d& b, int mask) {
    const Vector3d normal = (a - newest_).cross(b - newest_);
    const double squared = normal.squaredNorm();
    if (!(squared > 0.0)) return;
    const Vector3d foot = normal * (normal.dot(newest_) / squared);
    const auto inside = [&](const Vector3d& from, const Vector3d& to) {
      return (to - from).cross(foot - from).dot(normal) >= 0.0;
    };
    if (inside(newest_, a) && inside(a, b) && inside(b, newest_)) offer(foot, mask);
  }

  void tryTetrahedron(const Vector3d& a, const Vector3d& b, const Vector3d& c, int mask) {
    const double longest = std::max({(a - newest_).norm(), (b - newest_).norm(), (c - newest_).norm()});
    const double volume = (a - newest_).cross(b - newest_).dot(c - newest_);
    if (std::abs(volume) <= kFlat * longest * longest * longest) return;
    const auto inside = [](const Vector3d& p, const Vector3d& q, const Vector3d& r,
                           const Vector3d& opposite) {
      const Vector3d normal = (q - p).cross(r - p);
      return normal.dot(opposite - p) * normal.dot(-p) >= 0.0;
    };
    if (inside(a, b, c, newest_) && inside(newest_, a, b, c) && inside(newest_, b, c, a) &&
        inside(newest_, c, a, b))
      offer(Vector3d::Zero(), mask);
  }

  std::array<Vector3d, 4> points_;
  int size_ = 0;
  Vector3d newest_ = Vector3d::Zero();
  Vector3d nearest_ = Vector3d::Zero();
  double best_norm_ = 0.0;
  int best_mask_ = 0;
};

Vector3d supportInWorld(const ConvexBody& body, const Eigen::Isometry3d& X_WS, const Vector3d& direction_W) {
  return X_WS * body.support(X_WS.linear().transpose() * direction_W);
}

}  // namespace

Separation separation(const ConvexBody& a, const Eigen::Isometry3d& X_WA, const ConvexBody& b,
                      const Eigen::Isometry3d& X_WB, const Vector3d& hint) {
  const double margin = a.margin() + b.margin();
  Separation widest{-std::numeric_limits<double>::infinity(), hint};
  double core_distance = std::numeric_limits<double>::infinity();  // from above
  Simplex simplex;
  Vector3d towards_a = hint.normalized();
  for (int i = 0; i < kMostIterations; ++i) {
    const Vector3d point = supportInWorld(a, X_WA, -towards_a) - supportInWorld(b, X_WB, towards_a);
    const double gap = towards_a.dot(point) - margin;
    if (gap > widest.distance_m) widest = {gap, towards_a};
    const double proved = widest.distance_m + margin;
    if (core_distance - proved <= std::max(kAbsoluteAccuracy_m, kRelativeAccuracy * proved)) break;
    simplex.add(point);
    const double nearer = simplex.nearest().norm();
    const bool overlap = nearer <= std::max(margin, kTouching_m);
    if (overlap || nearer >= core_distance) break;
    core_distance = nearer;
    towards_a = simplex.nearest() / nearer;
  }
  return widest;
}

}  // namespace b4p::verification
