// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/fcl_shapes.h"

#include <vector>

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>

namespace b4p {
namespace {

struct MakeFclShape {
  FclShape operator()(const Box& box) const { return std::make_shared<fcl::Boxd>(box.size); }
  FclShape operator()(const Sphere& sphere) const { return std::make_shared<fcl::Sphered>(sphere.radius); }
  FclShape operator()(const Cylinder& cylinder) const {
    return std::make_shared<fcl::Cylinderd>(cylinder.radius, cylinder.length);
  }
  FclShape operator()(const Capsule& capsule) const {
    return std::make_shared<fcl::Capsuled>(capsule.radius, capsule.length);
  }
  FclShape operator()(const std::shared_ptr<const ConvexMesh>& mesh) const {
    auto vertices = std::make_shared<std::vector<Eigen::Vector3d>>(mesh->vertices);
    auto faces = std::make_shared<std::vector<int>>();
    for (const std::array<int, 3>& triangle : mesh->triangles) {
      faces->push_back(static_cast<int>(triangle.size()));
      faces->insert(faces->end(), triangle.begin(), triangle.end());
    }
    return std::make_shared<fcl::Convexd>(vertices, static_cast<int>(mesh->triangles.size()), faces);
  }
};

}  // namespace

FclShape fclShape(const Shape& shape) { return std::visit(MakeFclShape{}, shape); }

}  // namespace b4p
