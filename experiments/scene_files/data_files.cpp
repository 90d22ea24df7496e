// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/scene_files/data_files.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "robots/input_error.h"

namespace b4p {

namespace fs = std::filesystem;

std::string dataFolder() {
  if (const char* folder = std::getenv("B4P_DATA_DIR")) return folder;
  std::error_code error;
  if (fs::is_directory(fs::path(B4P_SOURCE_DATA_DIR) / "robots", error)) return B4P_SOURCE_DATA_DIR;
  return B4P_INSTALL_DATA_DIR;
}

std::string nameFromAnywhere(const std::string& name_or_path) {
  return isPath(name_or_path) ? fs::absolute(name_or_path).lexically_normal().string() : name_or_path;
}

bool isPath(const std::string& name_or_path) {
  const fs::path path(name_or_path);
  const std::string first = path.empty() ? "" : path.begin()->string();
  return path.is_absolute() || first == "." || first == ".." || path.extension() == ".yaml" ||
         path.extension() == ".yml";
}

std::string relativeTo(const std::string& file, const std::string& path) {
  return (fs::path(file).parent_path() / path).lexically_normal().string();
}

std::vector<std::string> shippedNames(const std::string& folder) {
  const fs::path root = fs::path(dataFolder()) / folder;
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(root, error))
    if (entry.path().extension() == ".yaml")
      names.push_back(entry.path().lexically_relative(root).replace_extension().generic_string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string shippedFile(const std::string& folder, const std::string& kind, const std::string& name_or_path) {
  if (isPath(name_or_path)) return name_or_path;
  const auto names = shippedNames(folder);
  if (std::find(names.begin(), names.end(), name_or_path) == names.end()) {
    std::string known;
    for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
    throw InputError(name_or_path, "", "no " + kind + " of that name ships with b4p; there are: " + known);
  }
  return (fs::path(dataFolder()) / folder / (name_or_path + ".yaml")).string();
}

}  // namespace b4p
