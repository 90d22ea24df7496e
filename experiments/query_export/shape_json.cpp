// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/query_export/shape_json.h"

#include "experiments/result_json.h"

namespace b4p {
namespace {

Json listOf(const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }

/// Kind and sizes of a shape.
struct Sizes {
  Json operator()(const Box& box) const { return {{"box", {{"size_m", listOf(box.size)}}}}; }
  Json operator()(const Sphere& sphere) const { return {{"sphere", {{"radius_m", sphere.radius}}}}; }
  Json operator()(const Cylinder& cylinder) const {
    return {{"cylinder", {{"radius_m", cylinder.radius}, {"length_m", cylinder.length}}}};
  }
  Json operator()(const Capsule& capsule) const {
    return {{"capsule", {{"radius_m", capsule.radius}, {"length_m", capsule.length}}}};
  }
  Json operator()(const std::shared_ptr<const ConvexMesh>& mesh) const {
    Json vertices = Json::array();
    for (const Eigen::Vector3d& vertex : mesh->vertices) vertices.push_back(listOf(vertex));
    return {{"hull", {{"vertices_m", std::move(vertices)}}}};
  }
};

}  // namespace

Json shapeJson(const PlacedShape& placed, const char* pose_key) {
  Json shape = std::visit(Sizes(), placed.shape);
  shape[pose_key] = poseJson(placed.X_BS, pose_key);
  return shape;
}

}  // namespace b4p
