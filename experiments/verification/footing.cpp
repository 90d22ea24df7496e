// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/verification/footing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "experiments/verification/number_text.h"
#include "experiments/verification/separation.h"

namespace b4p::verification {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kLevel_rad = 0.01;  // a face tilted by less is horizontal
constexpr double kUneven_m = 3e-4;   // corners of a face are off its plane by less
constexpr double kSureFooting_m = 8e-3;
constexpr double kSlack_m = 1e-3;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
const double kFullTurn_rad = 2.0 * std::acos(-1.0);

/// Points of a shape, in S, that include those it can stand on.
struct Corners {
  Vector3d down_S;

  std::vector<Vector3d> operator()(const Box& box) const {
    std::vector<Vector3d> points;
    for (int i = 0; i < 8; ++i)
      points.push_back(0.5 * box.size.cwiseProduct(Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
    return points;
  }
  std::vector<Vector3d> operator()(const Cylinder& cylinder) const {
    constexpr int kRim = 64;
    const double sideways = down_S.head<2>().norm();
    const bool upright = sideways <= std::sin(kLevel_rad);
    // Lying, it touches along a line.
    const double lowest_rad = std::atan2(down_S.y(), down_S.x());
    std::vector<Vector3d> points;
    for (int i = 0; i < (upright ? kRim : 1); ++i)
      for (const double side : {-0.5, 0.5}) {
        const double angle = lowest_rad + kFullTurn_rad * i / kRim;
        points.emplace_back(cylinder.radius * std::cos(angle), cylinder.radius * std::sin(angle),
                            side * cylinder.length);
      }
    return points;
  }
  // Round things touch in points that depend on the pose; they are never a face.
  std::vector<Vector3d> operator()(const Sphere&) const { return {}; }
  std::vector<Vector3d> operator()(const Capsule&) const { return {}; }
  std::vector<Vector3d> operator()(const std::shared_ptr<const ConvexMesh>& mesh) const {
    return mesh->vertices;
  }
};

}  // namespace

Footing::Footing(const Scene& scene) : scene_(scene) {
  for (const Obstacle& obstacle : scene.obstacles)
    obstacles_.push_back({ConvexBody::of(obstacle.shape.shape), obstacle.shape.X_BS});
}

std::vector<Vector3d> Footing::feet(const Isometry3d& X_WO) const {
  std::vector<Vector3d> points;
  Vector3d lowest = Vector3d::Constant(kInfinity);
  for (const PlacedShape& shape : scene_.placing().object) {
    const Isometry3d X_WS = X_WO * shape.X_BS;
    const Vector3d down_S = X_WS.linear().transpose() * -Vector3d::UnitZ();
    const ConvexBody body = ConvexBody::of(shape.shape);
    const Vector3d p_W = X_WS * body.support(down_S) - body.margin() * Vector3d::UnitZ();
    if (p_W.z() < lowest.z()) lowest = p_W;
    for (const Vector3d& p_S : std::visit(Corners{down_S}, shape.shape)) points.push_back(X_WS * p_S);
  }
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](const Vector3d& p) {
                                const double level = std::tan(kLevel_rad) * (p - lowest).head<2>().norm();
                                return p.z() > lowest.z() + kUneven_m + level;
                              }),
               points.end());
  return points;
}

double Footing::gap_m(const Vector3d& p_W, double farthest_m) const {
  constexpr int kHalvings = 16;
  const auto touches = [&](double length_m) {
    const ConvexBody plumb = ConvexBody::hull({p_W, p_W - length_m * Vector3d::UnitZ()});
    return std::any_of(obstacles_.begin(), obstacles_.end(), [&](const PlacedBody& obstacle) {
      return !separation(plumb, Isometry3d::Identity(), obstacle.body, obstacle.X_LS, Vector3d::UnitZ())
                  .apart();
    });
  };
  if (!touches(farthest_m)) return kInfinity;
  double free_m = 0.0, touching_m = farthest_m;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle_m = 0.5 * (free_m + touching_m);
    (touches(middle_m) ? touching_m : free_m) = middle_m;
  }
  return touching_m;
}

std::string Footing::problem(const Isometry3d& X_WO, double& largest_gap_m) const {
  constexpr int kDirections = 720;
  const PlacementTask& task = scene_.placing();
  const double farthest_m = 1.5 * task.cell_m + kSlack_m;
  const std::vector<Vector3d> standing = feet(X_WO);
  largest_gap_m = 0.0;
  for (const Vector3d& foot : standing) {
    const double gap = gap_m(foot, farthest_m);
    const std::string place = "(" + text(foot.x()) + ", " + text(foot.y()) + ", " + text(foot.z()) + ") m";
    if (std::isinf(gap)) return "nothing carries the object's foot at " + place;
    largest_gap_m = std::max(largest_gap_m, gap);
    if (((foot - task.min_m).array() < -kSlack_m).any() || ((foot - task.max_m).array() > kSlack_m).any())
      return "the object's foot at " + place + " is outside the target volume";
  }
  const Eigen::Vector2d p_WCom = (X_WO * task.p_OCom).head<2>();
  for (int i = 0; i < kDirections; ++i) {
    const double angle = kFullTurn_rad * i / kDirections;
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    const bool falls = std::none_of(standing.begin(), standing.end(), [&](const Vector3d& foot) {
      return direction.dot(foot.head<2>() - p_WCom) > kSureFooting_m;
    });
    if (falls) return "the object's centre of mass does not stand above its feet";
  }
  return "";
}

}  // namespace b4p::verification
