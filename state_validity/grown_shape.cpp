// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/grown_shape.h"

#include "state_validity/grown_mesh.h"

namespace b4p {
namespace {

struct Grow {
  double padding_m;

  Shape operator()(const Box& box) const { return Box{box.size.array() + 2.0 * padding_m}; }
  Shape operator()(const Sphere& sphere) const { return Sphere{sphere.radius + padding_m}; }
  Shape operator()(const Cylinder& cylinder) const {
    return Cylinder{cylinder.radius + padding_m, cylinder.length + 2.0 * padding_m};
  }
  Shape operator()(const Capsule& capsule) const {
    return Capsule{capsule.radius + padding_m, capsule.length};
  }
  Shape operator()(const std::shared_ptr<const ConvexMesh>& mesh) const {
    return grownMesh(*mesh, padding_m);
  }
};

}  // namespace

Shape grownShape(const Shape& shape, double padding_m) {
  return padding_m > 0.0 ? std::visit(Grow{padding_m}, shape) : shape;
}

}  // namespace b4p
