// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/certification/digest.h"

#include <cstdint>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <sstream>
#include <vector>

#include "robots/input_error.h"

namespace b4p {
namespace {

void add(const std::string& bytes, std::uint64_t& hash) {
  constexpr std::uint64_t kPrime = 0x100000001b3;
  for (const char byte : bytes) {
    hash ^= static_cast<unsigned char>(byte);
    hash *= kPrime;
  }
}

std::string content(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in) throw InputError(file, "", "cannot be read");
  return bytes;
}

}  // namespace

std::string sceneDigest(const Scene& scene) {
  std::uint64_t hash = 0xcbf29ce484222325;
  std::vector<std::string> files{scene.file, scene.robot.file, scene.robot.urdf_file};
  const auto* task = std::get_if<PickPlaceTask>(&scene.task);
  if (task != nullptr && !task->grasps.grasp_file.empty()) files.push_back(task->grasps.grasp_file);
  for (const std::string& file : files) {
    const std::string bytes = content(file);
    add(std::to_string(bytes.size()) + "\n" + bytes, hash);  // the length keeps the files apart
  }
  std::ostringstream text;
  text << "fnv1a64:" << std::hex << std::setw(16) << std::setfill('0') << hash;
  return text.str();
}

}  // namespace b4p
