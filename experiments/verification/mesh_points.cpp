// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/verification/mesh_points.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <tuple>

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include "robots/input_error.h"

namespace b4p::verification {
namespace {

namespace fs = std::filesystem;

const std::string kPackageScheme = "package://";
const std::string kFileScheme = "file://";

bool startsWith(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

/// The folders where packages may lie, nearest first.
std::vector<fs::path> packageFolders(const fs::path& urdf_folder) {
  std::vector<fs::path> folders;
  for (fs::path folder = urdf_folder;; folder = folder.parent_path()) {
    folders.push_back(folder);
    if (folder == folder.parent_path()) break;
  }
  const char* variable = std::getenv("ROS_PACKAGE_PATH");
  std::istringstream list(variable == nullptr ? "" : variable);
  for (std::string folder; std::getline(list, folder, ':');)
    if (!folder.empty()) folders.emplace_back(folder);
  return folders;
}

/// Empty when there is none.
fs::path findInPackages(const std::string& name_and_rest, const fs::path& urdf_folder) {
  const std::size_t slash = name_and_rest.find('/');
  if (slash == std::string::npos) return {};
  const fs::path name = name_and_rest.substr(0, slash), rest = name_and_rest.substr(slash + 1);
  for (const fs::path& folder : packageFolders(urdf_folder)) {
    std::error_code error;
    if (fs::is_regular_file(folder / name / rest, error)) return folder / name / rest;
    if (folder.filename() == name && fs::is_regular_file(folder / rest, error)) return folder / rest;
  }
  return {};
}

fs::path resolve(const std::string& reference, const std::string& urdf_file) {
  const fs::path urdf_folder = fs::absolute(urdf_file).parent_path();
  if (startsWith(reference, kPackageScheme))
    return findInPackages(reference.substr(kPackageScheme.size()), urdf_folder);
  const fs::path path =
      urdf_folder / (startsWith(reference, kFileScheme) ? reference.substr(kFileScheme.size()) : reference);
  std::error_code error;
  return fs::is_regular_file(path, error) ? path : fs::path();
}

void keepEachOnce(std::vector<Eigen::Vector3d>& points) {
  const auto key = [](const Eigen::Vector3d& p) { return std::make_tuple(p.x(), p.y(), p.z()); };
  std::sort(points.begin(), points.end(), [&key](const auto& a, const auto& b) { return key(a) < key(b); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

}  // namespace

std::vector<Eigen::Vector3d> readMeshPoints(const std::string& reference, const std::string& urdf_file,
                                            const std::string& element) {
  const fs::path path = resolve(reference, urdf_file);
  if (path.empty()) throw InputError(urdf_file, element, "mesh '" + reference + "' does not exist");
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);  // URDF's convention
  const aiScene* scene = importer.ReadFile(path.string(), aiProcess_PreTransformVertices);
  std::vector<Eigen::Vector3d> points;
  for (unsigned m = 0; scene != nullptr && m < scene->mNumMeshes; ++m)
    for (unsigned v = 0; v < scene->mMeshes[m]->mNumVertices; ++v) {
      const aiVector3D& p = scene->mMeshes[m]->mVertices[v];
      points.emplace_back(p.x, p.y, p.z);
    }
  const bool finite = std::all_of(points.begin(), points.end(), [](const auto& p) { return p.allFinite(); });
  if (points.empty() || !finite)
    throw InputError(urdf_file, element, "mesh '" + reference + "' cannot be read");
  keepEachOnce(points);
  return points;
}

}  // namespace b4p::verification
