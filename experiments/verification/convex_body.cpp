// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/verification/convex_body.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace b4p::verification {
namespace {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace

ConvexBody ConvexBody::box(const Eigen::Vector3d& size) {
  ConvexBody body;
  body.half_ = size / 2.0;
  body.radius_ = body.half_.norm();
  return body;
}

ConvexBody ConvexBody::sphere(double radius) {
  ConvexBody body;
  body.margin_ = body.radius_ = radius;
  return body;
}

ConvexBody ConvexBody::cylinder(double radius, double length) {
  ConvexBody body;
  body.core_ = Core::kCylinder;
  body.half_ << radius, radius, length / 2.0;
  body.radius_ = std::hypot(radius, length / 2.0);
  return body;
}

ConvexBody ConvexBody::capsule(double radius, double length) {
  ConvexBody body;
  body.half_.z() = length / 2.0;
  body.margin_ = radius;
  body.radius_ = radius + length / 2.0;
  return body;
}

ConvexBody ConvexBody::hull(std::vector<Eigen::Vector3d> points) {
  ConvexBody body;
  body.core_ = Core::kPoints;
  body.points_ = std::move(points);
  Eigen::AlignedBox3d extent;
  for (const Eigen::Vector3d& p : body.points_) extent.extend(p);
  body.centre_ = extent.center();
  for (const Eigen::Vector3d& p : body.points_)
    body.radius_ = std::max(body.radius_, (p - body.centre_).norm());
  return body;
}

ConvexBody ConvexBody::of(const Shape& shape) {
  return std::visit(
      Overloaded{[](const Box& s) { return box(s.size); }, [](const Sphere& s) { return sphere(s.radius); },
                 [](const Cylinder& s) { return cylinder(s.radius, s.length); },
                 [](const Capsule& s) { return capsule(s.radius, s.length); },
                 [](const std::shared_ptr<const ConvexMesh>& s) { return hull(s->vertices); }},
      shape);
}

Eigen::Vector3d ConvexBody::support(const Eigen::Vector3d& direction) const {
  switch (core_) {
    case Core::kBox:
      return {std::copysign(half_.x(), direction.x()), std::copysign(half_.y(), direction.y()),
              std::copysign(half_.z(), direction.z())};
    case Core::kCylinder: {
      const double across = std::hypot(direction.x(), direction.y());
      const double scale = across > 0.0 ? half_.x() / across : 0.0;
      return {scale * direction.x(), scale * direction.y(), std::copysign(half_.z(), direction.z())};
    }
    case Core::kPoints:
      break;
  }
  return *std::max_element(points_.begin(), points_.end(), [&direction](const auto& a, const auto& b) {
    return a.dot(direction) < b.dot(direction);
  });
}

}  // namespace b4p::verification
