// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/scene.h"
#include "experiments/scene_files/data_files.h"
#include "experiments/scene_files/yaml_value.h"

namespace b4p {
namespace {

constexpr int kRobotSchema = 1;

std::vector<std::string> readNames(const YamlValue& list) {
  std::vector<std::string> names;
  for (const YamlValue& item : list.items()) names.push_back(item.text());
  return names;
}

std::vector<std::pair<std::string, std::string>> readPairs(const YamlValue& list) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const YamlValue& item : list.items()) {
    const auto names = readNames(item);
    if (names.size() != 2) item.failWithValue("is not a pair of links");
    pairs.emplace_back(names[0], names[1]);
  }
  return pairs;
}

}  // namespace

RobotFile loadRobotFile(const std::string& name_or_path) {
  RobotFile robot;
  robot.file = shippedFile("robots", "robot", name_or_path);
  const YamlValue document = YamlValue::load(robot.file);
  document.requireSchema(kRobotSchema);
  document.allowKeys({"schema", "urdf", "tcp_link", "joints", "gripper", "skip_self_collision", "rest"});
  robot.urdf_file = relativeTo(robot.file, document["urdf"].text());
  ManipulatorDescription& description = robot.description;
  description.tcp_link = document["tcp_link"].text();
  description.joints = readNames(document["joints"]);
  if (description.joints.empty()) document["joints"].fail("is empty");
  const YamlValue gripper = document["gripper"];
  gripper.allowKeys({"finger_joints", "finger_links", "max_opening_m"});
  description.finger_joints = readNames(gripper["finger_joints"]);
  description.finger_links = readNames(gripper["finger_links"]);
  description.max_opening_m = gripper["max_opening_m"].number(0.0, kFarthest_m);
  if (const auto pairs = document.find("skip_self_collision"))
    description.skip_self_collision = readPairs(*pairs);
  if (const auto rest = document.find("rest"))
    for (const auto& [joint, value] : rest->entries())
      if (!description.rest.emplace(joint, value.number()).second) value.fail("duplicate key");
  return robot;
}

}  // namespace b4p
