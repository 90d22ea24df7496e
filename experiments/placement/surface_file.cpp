// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/surface_file.h"

#include <vector>

#include <nlohmann/json.hpp>

#include "experiments/output_file.h"
#include "experiments/placement/solid.h"

namespace b4p {
namespace {

constexpr int kSchema = 1;

template <class Vector>
nlohmann::ordered_json json(const Vector& v) {
  return std::vector<double>(v.data(), v.data() + v.size());
}

nlohmann::ordered_json points(const std::vector<Eigen::Vector3d>& list) {
  nlohmann::ordered_json array = nlohmann::ordered_json::array();
  for (const Eigen::Vector3d& p : list) array.push_back(json(p));
  return array;
}

}  // namespace

void writeSurfaces(const std::string& file, const Scene& scene, const PlacementGeometry& geometry) {
  nlohmann::ordered_json document{
      {"schema", kSchema},
      {"scene", scene.name},
      {"object", scene.object_name},
      {"volume", {{"min_m", json(scene.place->min_m)}, {"max_m", json(scene.place->max_m)}}},
      {"cell_m", scene.place->cell_m}};
  for (const char* list : {"obstacles", "shapes", "regions", "faces"})
    document[list] = nlohmann::ordered_json::array();
  for (const Obstacle& obstacle : scene.obstacles)
    document["obstacles"].push_back(
        {{"name", obstacle.name}, {"points_m", points(hullPoints({obstacle.shape}))}});
  for (const PlacedShape& shape : scene.object) document["shapes"].push_back(points(hullPoints({shape})));
  for (const ContactRegion& region : geometry.surfaces().regions()) {
    nlohmann::ordered_json cells = nlohmann::ordered_json::array();
    for (const Eigen::Vector2d& cell : region.cells) cells.push_back(json(cell));
    document["regions"].push_back({{"height_m", region.height_m}, {"cells_m", std::move(cells)}});
  }
  for (const PlacementFace& face : geometry.faces()) document["faces"].push_back(points(face.vertices_O));
  writeFile(file, document.dump() + "\n");
}

}  // namespace b4p
