// SPDX-License-Identifier: BSD-3-Clause
#include "robots/shape.h"

#include <algorithm>
#include <cmath>

#include "robots/mesh_check.h"
#include "robots/number_text.h"

namespace b4p {
namespace {

std::string lengthProblem(const char* quantity, double value, bool zero_allowed) {
  if (std::isfinite(value) && (zero_allowed ? value >= 0.0 : value > 0.0)) return {};
  return std::string(quantity) + (zero_allowed ? " has to be at least zero" : " has to be positive") +
         " and finite, not " + numberText(value);
}

struct Problem {
  std::string operator()(const Box& box) const {
    for (const double side : box.size)
      if (auto problem = lengthProblem("box size", side, false); !problem.empty()) return problem;
    return {};
  }
  std::string operator()(const Sphere& sphere) const {
    return lengthProblem("sphere radius", sphere.radius, false);
  }
  std::string operator()(const Cylinder& cylinder) const {
    auto problem = lengthProblem("cylinder radius", cylinder.radius, false);
    return problem.empty() ? lengthProblem("cylinder length", cylinder.length, false) : problem;
  }
  std::string operator()(const Capsule& capsule) const {
    auto problem = lengthProblem("capsule radius", capsule.radius, false);
    return problem.empty() ? lengthProblem("capsule length", capsule.length, true) : problem;
  }
  std::string operator()(const std::shared_ptr<const ConvexMesh>& mesh) const {
    return mesh ? meshProblem(*mesh) : "mesh is missing";
  }
};

/// Largest distance from a point in the shape's frame S.
struct DistanceFromPoint {
  const Eigen::Vector3d& p_S;

  double operator()(const Box& box) const { return (p_S.cwiseAbs() + box.size / 2.0).norm(); }
  double operator()(const Sphere& sphere) const { return p_S.norm() + sphere.radius; }
  double operator()(const Cylinder& cylinder) const {
    return std::hypot(p_S.head<2>().norm() + cylinder.radius, std::abs(p_S.z()) + cylinder.length / 2.0);
  }
  double operator()(const Capsule& capsule) const {
    return std::hypot(p_S.head<2>().norm(), std::abs(p_S.z()) + capsule.length / 2.0) + capsule.radius;
  }
  double operator()(const std::shared_ptr<const ConvexMesh>& mesh) const {
    double farthest = 0.0;
    for (const Eigen::Vector3d& vertex : mesh->vertices) farthest = std::max(farthest, (vertex - p_S).norm());
    return farthest;
  }
};

/// Largest distance from a line in S. The distance from a line is a convex function, so that it is largest
/// at an extreme point of the shape.
struct DistanceFromLine {
  const Eigen::Vector3d& p_S;
  const Eigen::Vector3d& u_S;

  double at(const Eigen::Vector3d& point) const { return u_S.cross(point - p_S).norm(); }

  double operator()(const Box& box) const {
    double farthest = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d sign((corner & 1) ? 0.5 : -0.5, (corner & 2) ? 0.5 : -0.5,
                                 (corner & 4) ? 0.5 : -0.5);
      farthest = std::max(farthest, at(sign.cwiseProduct(box.size)));
    }
    return farthest;
  }
  double operator()(const Sphere& sphere) const { return at(Eigen::Vector3d::Zero()) + sphere.radius; }
  double operator()(const Cylinder& cylinder) const {
    return std::max(disc(cylinder.length / 2.0, cylinder.radius),
                    disc(-cylinder.length / 2.0, cylinder.radius));
  }
  double operator()(const Capsule& capsule) const {
    const Eigen::Vector3d end(0.0, 0.0, capsule.length / 2.0);
    return std::max(at(end), at(-end)) + capsule.radius;
  }
  double operator()(const std::shared_ptr<const ConvexMesh>& mesh) const {
    double farthest = 0.0;
    for (const Eigen::Vector3d& vertex : mesh->vertices) farthest = std::max(farthest, at(vertex));
    return farthest;
  }

  /// Bound for the disc of the given radius at height z. Seen along the line the disc is an ellipse whose
  /// minor half-axis is radius * |cos| of the angle between line and z. Two figures around the ellipse bound
  /// it: its circumscribed circle and its bounding rectangle; the first is exact along z, the second across
  /// it.
  double disc(double z, double radius) const {
    const Eigen::Vector3d offset = Eigen::Vector3d(0.0, 0.0, z) - p_S;
    const Eigen::Vector3d seen = offset - u_S.dot(offset) * u_S;
    const double circle = seen.norm() + radius;
    const Eigen::Vector3d major = u_S.cross(Eigen::Vector3d::UnitZ());
    const double sine = major.norm();
    if (sine == 0.0) return circle;
    const double along_major = std::abs(major.dot(seen)) / sine;
    const double along_minor = std::sqrt(std::max(0.0, seen.squaredNorm() - along_major * along_major));
    return std::min(circle, std::hypot(along_major + radius, along_minor + radius * std::abs(u_S.z())));
  }
};

}  // namespace

std::string shapeProblem(const Shape& shape) { return std::visit(Problem{}, shape); }

double farthestDistance(const PlacedShape& placed, const Eigen::Vector3d& p_B) {
  const Eigen::Vector3d p_S = placed.X_BS.inverse() * p_B;
  return std::visit(DistanceFromPoint{p_S}, placed.shape);
}

double farthestDistanceFromLine(const PlacedShape& placed, const Eigen::Vector3d& p_B,
                                const Eigen::Vector3d& u_B) {
  const Eigen::Vector3d p_S = placed.X_BS.inverse() * p_B;
  const Eigen::Vector3d u_S = placed.X_BS.linear().transpose() * u_B;
  return std::visit(DistanceFromLine{p_S, u_S}, placed.shape);
}

}  // namespace b4p
