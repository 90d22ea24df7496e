// SPDX-License-Identifier: BSD-3-Clause
#include "robots/mesh_loader.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

namespace b4p {
namespace {

namespace fs = std::filesystem;

bool isFolder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

/// `place` itself when it bears the package's name, else its subfolder of that name; empty when there is
/// neither.
fs::path packageAt(const fs::path& place, const std::string& name) {
  if (place.filename() == name && isFolder(place)) return place;
  return isFolder(place / name) ? place / name : fs::path();
}

/// The path without a slash at its end, which would hide its last name.
fs::path withoutSlash(const fs::path& path) { return path.has_filename() ? path : path.parent_path(); }

std::vector<fs::path> searchedFolders(const fs::path& folder) {
  std::vector<fs::path> folders;
  for (fs::path place = folder;; place = place.parent_path()) {
    folders.push_back(place);
    if (place == place.parent_path()) break;
  }
  if (const char* listed = std::getenv("ROS_PACKAGE_PATH")) {
    std::istringstream entries(listed);
    for (std::string entry; std::getline(entries, entry, ':');)
      if (!entry.empty()) folders.push_back(withoutSlash(fs::path(entry).lexically_normal()));
  }
  return folders;
}

fs::path inPackage(const std::string& rest, const fs::path& folder) {
  const std::size_t slash = rest.find('/');
  const std::string name = rest.substr(0, slash);
  if (name.empty() || slash == std::string::npos)
    throw std::runtime_error("the address names no package and file, as package://NAME/FILE");
  for (const fs::path& place : searchedFolders(folder))
    if (const fs::path package = packageAt(place, name); !package.empty())
      return package / rest.substr(slash + 1);
  throw std::runtime_error("no folder '" + name + "' above the URDF or in ROS_PACKAGE_PATH");
}

bool startsWith(const std::string& text, const std::string& prefix) {
  return text.compare(0, prefix.size(), prefix) == 0;
}

}  // namespace

std::string meshFile(const std::string& address, const std::string& folder) {
  static const std::string kPackage = "package://", kFile = "file://";
  const fs::path base = withoutSlash(fs::absolute(folder.empty() ? "." : folder).lexically_normal());
  fs::path file;
  if (startsWith(address, kPackage))
    file = inPackage(address.substr(kPackage.size()), base);
  else if (startsWith(address, kFile))
    file = address.substr(kFile.size());
  else
    file = base / address;
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) throw std::runtime_error("no such file: " + file.string());
  return file.string();
}

namespace {

/// What a mesh file holds, scaled; three points a triangle.
struct Soup {
  std::vector<Eigen::Vector3d> corners;
  unsigned parts = 0;
};

Soup readMesh(const std::string& file, const Eigen::Vector3d& scale) {
  if (!scale.allFinite() || (scale.array() == 0.0).any())
    throw std::runtime_error("the scale has to be finite and not zero");
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  // Pre-transforming puts all parts of the file into one frame.
  const aiScene* scene = importer.ReadFile(file, aiProcess_Triangulate | aiProcess_PreTransformVertices);
  if (scene == nullptr || scene->mNumMeshes == 0) throw std::runtime_error("holds no mesh that can be read");
  Soup soup;
  soup.parts = scene->mNumMeshes;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      if (mesh.mFaces[f].mNumIndices != 3) continue;  // lone points and lines enclose nothing
      for (unsigned i = 0; i < 3; ++i) {
        const aiVector3D& p = mesh.mVertices[mesh.mFaces[f].mIndices[i]];
        soup.corners.emplace_back(scale.cwiseProduct(Eigen::Vector3d(p.x, p.y, p.z)));
      }
    }
  }
  return soup;
}

std::shared_ptr<const ConvexMesh> hullOf(const Soup& soup) {
  try {
    return convexHull(soup.corners);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(error.what());
  }
}

/// Whether all corners lie on one side of the plane of each triangle.
bool isConvex(const Soup& soup) {
  constexpr double kTolerance_m = 1e-6;
  for (std::size_t f = 0; f + 2 < soup.corners.size(); f += 3) {
    const Eigen::Vector3d& a = soup.corners[f];
    const Eigen::Vector3d normal = (soup.corners[f + 1] - a).cross(soup.corners[f + 2] - a).normalized();
    double below = 0.0, above = 0.0;
    for (const Eigen::Vector3d& corner : soup.corners) {
      below = std::min(below, normal.dot(corner - a));
      above = std::max(above, normal.dot(corner - a));
    }
    if (below < -kTolerance_m && above > kTolerance_m) return false;
  }
  return true;
}

}  // namespace

std::shared_ptr<const ConvexMesh> loadMeshHull(const std::string& file, const Eigen::Vector3d& scale) {
  return hullOf(readMesh(file, scale));
}

std::shared_ptr<const ConvexMesh> loadConvexMesh(const std::string& file, const Eigen::Vector3d& scale) {
  const Soup soup = readMesh(file, scale);
  if (soup.parts > 1) throw std::runtime_error("holds several meshes");
  if (!isConvex(soup)) throw std::runtime_error("is not convex");
  return hullOf(soup);
}

}  // namespace b4p
