// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/scene.h"

#include <limits>
#include <set>

#include "experiments/placement/placement_file.h"
#include "experiments/scene_files/data_files.h"
#include "experiments/scene_files/shape_reader.h"
#include "experiments/scene_files/task_readers.h"
#include "experiments/scene_files/yaml_value.h"
#include "robots/input_error.h"

namespace b4p {
namespace {

constexpr int kSceneSchema = 1;
constexpr double kFinestStep_m = 1e-5, kCoarsestStep_m = 0.5;
constexpr const char* kSceneFolder = "experiments/scenes";
constexpr const char* kReach = "reach";
constexpr const char* kPlace = "place";
const std::vector<const char*> kPickPlaceKeys{"contact_clearance_m", "object", "grasps", "placement"};

RobotFile readRobot(const YamlValue& name, const std::string& scene_file) {
  const std::string robot = name.text();
  if (isPath(robot)) return loadRobotFile(relativeTo(scene_file, robot));
  try {
    return loadRobotFile(robot);
  } catch (const InputError& e) {
    // An error inside a shipped robot file names that file; an unknown name is this file's fault.
    if (std::string(e.what()).rfind(robot + ": ", 0) != 0) throw;
    name.failWithValue("names no robot that ships with b4p");
  }
}

std::vector<Obstacle> readObstacles(const YamlValue& list) {
  std::vector<Obstacle> obstacles;
  std::set<std::string> names;
  for (const YamlValue& item : list.items()) {
    Obstacle obstacle{item["name"].text(), readPlacedShape(item, {"name"})};
    if (!names.insert(obstacle.name).second) item["name"].failWithValue("is the name of an earlier obstacle");
    obstacles.push_back(std::move(obstacle));
  }
  return obstacles;
}

/// Where a scene comes from is for people and for `b4p generate`; it only has to be well-formed.
void checkGenerated(const YamlValue& generated) {
  generated.allowKeys({"family", "seed", "difficulty", "parameters"});
  generated["family"].word();
  generated["seed"].integer(0, std::numeric_limits<int>::max());
  generated["difficulty"].number(0.0, 1.0);
  for (const auto& [name, value] : generated["parameters"].entries()) value.number();
}

void readSettings(const YamlValue& document, Scene& scene) {
  scene.edge_step_m = document["edge_step_m"].number(kFinestStep_m, kCoarsestStep_m);
  scene.budget_s = document["budget_s"].positive();
}

}  // namespace

Scene loadScene(const std::string& name_or_path) {
  const std::string file = shippedFile(kSceneFolder, "scene", name_or_path);
  const YamlValue document = YamlValue::load(file);
  document.requireSchema(kSceneSchema);
  std::vector<const char*> keys{"schema",      "name",     "robot",     "robot_base",
                                "edge_step_m", "budget_s", "generated", "obstacles"};
  const auto place = document.find(kPlace);
  const std::vector<const char*> task_keys = document.has(kReach) ? std::vector<const char*>{kReach}
                                             : place              ? std::vector<const char*>{kPlace, "object"}
                                                                  : kPickPlaceKeys;
  keys.insert(keys.end(), task_keys.begin(), task_keys.end());
  document.allowKeys(keys);
  if (const auto generated = document.find("generated")) checkGenerated(*generated);
  Scene scene;
  scene.file = file;
  scene.name = document["name"].word();
  scene.robot = readRobot(document["robot"], file);
  if (const auto base = document.find("robot_base")) {
    base->allowKeys({"position_m", "rpy_rad", "quaternion_wxyz"});
    scene.X_WB = poseFrom(*base);
  }
  readSettings(document, scene);
  scene.obstacles = readObstacles(document["obstacles"]);
  if (const auto reach = document.find(kReach))
    scene.task = readReachTask(*reach, scene);
  else if (place)
    scene.task = readPlacementTask(*place, document["object"], scene);
  else
    scene.task = readPickPlaceTask(document, scene);
  return scene;
}

std::vector<std::string> sceneNames() { return shippedNames(kSceneFolder); }

}  // namespace b4p
