// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/samplers/surface.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "experiments/samplers/unit_draw.h"

namespace b4p {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Per shape, in its own frame: area, a uniform point, the signed distance, the outward normal.

double area(const Box& box) {
  return 2.0 * (box.size.x() * box.size.y() + box.size.y() * box.size.z() + box.size.z() * box.size.x());
}
double area(const Sphere& sphere) { return 4.0 * kPi * sphere.radius * sphere.radius; }
double area(const Cylinder& c) { return 2.0 * kPi * c.radius * (c.length + c.radius); }
double area(const Capsule& c) { return 2.0 * kPi * c.radius * (c.length + 2.0 * c.radius); }

Eigen::Vector3d onUnitSphere(std::mt19937_64& random) {
  const double z = 2.0 * unitDraw(random) - 1.0, turn = 2.0 * kPi * unitDraw(random);
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

Eigen::Vector3d onCircle(std::mt19937_64& random) {
  const double turn = 2.0 * kPi * unitDraw(random);
  return {std::cos(turn), std::sin(turn), 0.0};
}

Eigen::Vector3d draw(const Box& box, std::mt19937_64& random) {
  const Eigen::Vector3d faces = box.size.prod() * box.size.cwiseInverse();
  double share = unitDraw(random) * faces.sum();
  int axis = 0;
  while (axis < 2 && share >= faces[axis]) share -= faces[axis++];
  Eigen::Vector3d p;
  for (int i = 0; i < 3; ++i) p[i] = (unitDraw(random) - 0.5) * box.size[i];
  p[axis] = p[axis] < 0.0 ? -box.size[axis] / 2.0 : box.size[axis] / 2.0;
  return p;
}

Eigen::Vector3d draw(const Sphere& sphere, std::mt19937_64& random) {
  return sphere.radius * onUnitSphere(random);
}

Eigen::Vector3d draw(const Cylinder& c, std::mt19937_64& random) {
  const bool mantle = unitDraw(random) * (c.length + c.radius) < c.length;
  const Eigen::Vector3d around = onCircle(random);
  const double along = unitDraw(random);
  if (mantle) return c.radius * around + (along - 0.5) * c.length * Eigen::Vector3d::UnitZ();
  const double end = unitDraw(random) < 0.5 ? -0.5 : 0.5;
  return c.radius * std::sqrt(along) * around + end * c.length * Eigen::Vector3d::UnitZ();
}

Eigen::Vector3d draw(const Capsule& c, std::mt19937_64& random) {
  const double along = (unitDraw(random) - 0.5) * (c.length + 2.0 * c.radius);
  if (std::abs(along) < c.length / 2.0) return c.radius * onCircle(random) + along * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d p = c.radius * onUnitSphere(random);
  return p + std::copysign(c.length / 2.0, p.z()) * Eigen::Vector3d::UnitZ();
}

/// From how far each coordinate is beyond its face.
template <typename Vector>
double distanceBeyond(const Vector& beyond) {
  return beyond.cwiseMax(0.0).norm() + std::min(beyond.maxCoeff(), 0.0);
}

Eigen::Vector3d beyondFaces(const Box& box, const Eigen::Vector3d& p) {
  return p.cwiseAbs() - box.size / 2.0;
}
Eigen::Vector2d beyondFaces(const Cylinder& c, const Eigen::Vector3d& p) {
  return {p.head<2>().norm() - c.radius, std::abs(p.z()) - c.length / 2.0};
}
Eigen::Vector3d fromAxis(const Capsule& c, const Eigen::Vector3d& p) {
  return p - std::clamp(p.z(), -c.length / 2.0, c.length / 2.0) * Eigen::Vector3d::UnitZ();
}

double distance(const Box& box, const Eigen::Vector3d& p) { return distanceBeyond(beyondFaces(box, p)); }
double distance(const Sphere& sphere, const Eigen::Vector3d& p) { return p.norm() - sphere.radius; }
double distance(const Cylinder& c, const Eigen::Vector3d& p) { return distanceBeyond(beyondFaces(c, p)); }
double distance(const Capsule& c, const Eigen::Vector3d& p) { return fromAxis(c, p).norm() - c.radius; }

Eigen::Vector3d outward(const Box& box, const Eigen::Vector3d& p) {
  Eigen::Index axis = 0;
  beyondFaces(box, p).maxCoeff(&axis);
  return std::copysign(1.0, p[axis]) * Eigen::Vector3d::Unit(axis);
}
Eigen::Vector3d outward(const Sphere&, const Eigen::Vector3d& p) { return p.normalized(); }
Eigen::Vector3d outward(const Cylinder& c, const Eigen::Vector3d& p) {
  const Eigen::Vector2d beyond = beyondFaces(c, p);
  if (beyond[1] > beyond[0]) return std::copysign(1.0, p.z()) * Eigen::Vector3d::UnitZ();
  return Eigen::Vector3d(p.x(), p.y(), 0.0).normalized();
}
Eigen::Vector3d outward(const Capsule& c, const Eigen::Vector3d& p) { return fromAxis(c, p).normalized(); }

}  // namespace

Surface::Primitive Surface::primitive(const Shape& shape) {
  return std::visit(
      [](const auto& kind) -> Primitive {
        if constexpr (std::is_constructible_v<Primitive, decltype(kind)>)
          return kind;
        else
          throw std::invalid_argument("the surface of a mesh is not sampled");
      },
      shape);
}

Surface::Surface(const PlacedShape& placed)
    : shape_(primitive(placed.shape)),
      X_BS_(placed.X_BS),
      X_SB_(placed.X_BS.inverse()),
      area_m2_(std::visit([](const auto& shape) { return area(shape); }, shape_)),
      diameter_m_(2.0 * farthestDistance(placed, placed.X_BS.translation())) {}

Eigen::Vector3d Surface::sample(std::mt19937_64& random) const {
  return X_BS_ * std::visit([&](const auto& shape) { return draw(shape, random); }, shape_);
}

double Surface::signedDistance(const Eigen::Vector3d& p_B) const {
  const Eigen::Vector3d p = X_SB_ * p_B;
  return std::visit([&](const auto& shape) { return distance(shape, p); }, shape_);
}

Eigen::Vector3d Surface::normal(const Eigen::Vector3d& p_B) const {
  const Eigen::Vector3d p = X_SB_ * p_B;
  return X_BS_.linear() * std::visit([&](const auto& shape) { return outward(shape, p); }, shape_);
}

// Along the ray the signed distance is convex, so it has one zero beyond the entrance.
Eigen::Vector3d Surface::exit(const Eigen::Vector3d& p_B, const Eigen::Vector3d& direction_B) const {
  constexpr double kAccuracy_m = 1e-12;
  double inside = 0.0;
  double outside = diameter_m_ + kAccuracy_m;
  while (outside - inside > kAccuracy_m) {
    const double middle = (inside + outside) / 2.0;
    (signedDistance(p_B + middle * direction_B) < 0.0 ? inside : outside) = middle;
  }
  return p_B + outside * direction_B;
}

}  // namespace b4p
