// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/scene_files/mesh_reader.h"

#include <algorithm>
#include <filesystem>

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

namespace b4p {
namespace {

constexpr double kConvexTolerance_m = 1e-6;

/// Whether all vertices lie behind the planes of all triangles.
bool isConvex(const aiMesh& mesh, const std::vector<Eigen::Vector3d>& vertices) {
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const unsigned* corners = mesh.mFaces[f].mIndices;
    const Eigen::Vector3d& a = vertices[corners[0]];
    const Eigen::Vector3d normal = (vertices[corners[1]] - a).cross(vertices[corners[2]] - a).normalized();
    const bool behind = std::all_of(vertices.begin(), vertices.end(), [&](const Eigen::Vector3d& v) {
      return normal.dot(v - a) <= kConvexTolerance_m;
    });
    if (!behind) return false;
  }
  return true;
}

}  // namespace

std::shared_ptr<const ConvexMesh> readConvexMesh(const std::string& file, const Eigen::Vector3d& scale,
                                                 bool take_hull) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) throw MeshError("no such mesh file");
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(
      file, aiProcess_Triangulate | aiProcess_JoinIdenticalVertices | aiProcess_PreTransformVertices);
  if (scene == nullptr || scene->mNumMeshes == 0) throw MeshError("holds no mesh that can be read");
  if (scene->mNumMeshes > 1 && !take_hull) throw MeshError("holds several meshes; set convex_hull: true");
  std::vector<Eigen::Vector3d> points;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m)
    for (unsigned v = 0; v < scene->mMeshes[m]->mNumVertices; ++v) {
      const aiVector3D& p = scene->mMeshes[m]->mVertices[v];
      points.emplace_back(scale.cwiseProduct(Eigen::Vector3d(p.x, p.y, p.z)));
    }
  if (!take_hull && !isConvex(*scene->mMeshes[0], points))
    throw MeshError("is not convex; set convex_hull: true to use its hull");
  try {
    return convexHull(points);
  } catch (const std::invalid_argument& e) {
    throw MeshError(e.what());
  }
}

}  // namespace b4p
