// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/solid.h"

#include <algorithm>
#include <cmath>

namespace b4p {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRounding_m = 1e-9;
constexpr int kPointsPerTurn = 64;

struct Contains {
  const Eigen::Vector3d& p;

  bool operator()(const Box& box) const { return (p.cwiseAbs() - box.size / 2.0).maxCoeff() <= kRounding_m; }
  bool operator()(const Sphere& sphere) const { return p.norm() <= sphere.radius + kRounding_m; }
  bool operator()(const Cylinder& cylinder) const {
    return p.head<2>().norm() <= cylinder.radius + kRounding_m &&
           std::abs(p.z()) <= cylinder.length / 2.0 + kRounding_m;
  }
  bool operator()(const Capsule& capsule) const {
    const double beyond = std::max(0.0, std::abs(p.z()) - capsule.length / 2.0);
    return std::hypot(p.head<2>().norm(), beyond) <= capsule.radius + kRounding_m;
  }
  bool operator()(const std::shared_ptr<const ConvexMesh>& mesh) const {
    for (const auto& t : mesh->triangles) {
      const Eigen::Vector3d& a = mesh->vertices[static_cast<std::size_t>(t[0])];
      const Eigen::Vector3d& b = mesh->vertices[static_cast<std::size_t>(t[1])];
      const Eigen::Vector3d& c = mesh->vertices[static_cast<std::size_t>(t[2])];
      const Eigen::Vector3d normal = (b - a).cross(c - a);
      if (normal.dot(p - a) > kRounding_m * normal.norm()) return false;
    }
    return true;
  }
};

struct Centroid {
  VolumeCentroid operator()(const Box& box) const { return {box.size.prod(), Eigen::Vector3d::Zero()}; }
  VolumeCentroid operator()(const Sphere& sphere) const {
    return {4.0 / 3.0 * kPi * std::pow(sphere.radius, 3), Eigen::Vector3d::Zero()};
  }
  VolumeCentroid operator()(const Cylinder& cylinder) const {
    return {kPi * cylinder.radius * cylinder.radius * cylinder.length, Eigen::Vector3d::Zero()};
  }
  VolumeCentroid operator()(const Capsule& capsule) const {
    const double r = capsule.radius;
    return {kPi * r * r * (capsule.length + 4.0 / 3.0 * r), Eigen::Vector3d::Zero()};
  }
  VolumeCentroid operator()(const std::shared_ptr<const ConvexMesh>& mesh) const {
    VolumeCentroid sum;
    const Eigen::Vector3d apex = mesh->vertices.front();
    for (const auto& t : mesh->triangles) {
      const Eigen::Vector3d a = mesh->vertices[static_cast<std::size_t>(t[0])] - apex;
      const Eigen::Vector3d b = mesh->vertices[static_cast<std::size_t>(t[1])] - apex;
      const Eigen::Vector3d c = mesh->vertices[static_cast<std::size_t>(t[2])] - apex;
      const double volume = a.dot(b.cross(c)) / 6.0;
      sum.volume_m3 += volume;
      sum.p_S += volume * (a + b + c) / 4.0;
    }
    sum.p_S = apex + sum.p_S / sum.volume_m3;
    return sum;
  }
};

struct Points {
  std::vector<Eigen::Vector3d> operator()(const Box& box) const {
    std::vector<Eigen::Vector3d> points;
    for (int corner = 0; corner < 8; ++corner)
      points.push_back(box.size.cwiseProduct(
          Eigen::Vector3d((corner & 1) - 0.5, ((corner >> 1) & 1) - 0.5, ((corner >> 2) & 1) - 0.5)));
    return points;
  }
  std::vector<Eigen::Vector3d> operator()(const Sphere& sphere) const { return ball(sphere.radius, 0.0); }
  std::vector<Eigen::Vector3d> operator()(const Cylinder& cylinder) const {
    std::vector<Eigen::Vector3d> points;
    for (const double z : {-cylinder.length / 2.0, cylinder.length / 2.0}) ring(cylinder.radius, z, points);
    return points;
  }
  std::vector<Eigen::Vector3d> operator()(const Capsule& capsule) const {
    return ball(capsule.radius, capsule.length / 2.0);
  }
  std::vector<Eigen::Vector3d> operator()(const std::shared_ptr<const ConvexMesh>& mesh) const {
    return mesh->vertices;
  }

  static void ring(double radius, double z, std::vector<Eigen::Vector3d>& points) {
    for (int i = 0; i < kPointsPerTurn; ++i) {
      const double angle = 2.0 * kPi * i / kPointsPerTurn;
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  }

  /// Two half balls, `half_length` above and below the origin.
  static std::vector<Eigen::Vector3d> ball(double radius, double half_length) {
    std::vector<Eigen::Vector3d> points{{0.0, 0.0, radius + half_length}, {0.0, 0.0, -radius - half_length}};
    for (int i = 0; i < kPointsPerTurn / 4; ++i) {
      const double latitude = 2.0 * kPi * i / kPointsPerTurn;
      for (const double side : {-1.0, 1.0})
        ring(radius * std::cos(latitude), side * (half_length + radius * std::sin(latitude)), points);
    }
    return points;
  }
};

}  // namespace

bool containsPoint(const Shape& shape, const Eigen::Vector3d& p_S) {
  return std::visit(Contains{p_S}, shape);
}

VolumeCentroid volumeCentroid(const Shape& shape) { return std::visit(Centroid{}, shape); }

Eigen::Vector3d centreOfMass(const std::vector<PlacedShape>& shapes) {
  double volume = 0.0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const PlacedShape& placed : shapes) {
    const VolumeCentroid one = volumeCentroid(placed.shape);
    volume += one.volume_m3;
    sum += one.volume_m3 * (placed.X_BS * one.p_S);
  }
  return sum / volume;
}

std::vector<Eigen::Vector3d> hullPoints(const std::vector<PlacedShape>& shapes) {
  std::vector<Eigen::Vector3d> points;
  for (const PlacedShape& placed : shapes)
    for (const Eigen::Vector3d& p_S : std::visit(Points{}, placed.shape)) points.push_back(placed.X_BS * p_S);
  return points;
}

}  // namespace b4p
