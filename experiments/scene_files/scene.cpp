// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/scene.h"

#include <cmath>
#include <limits>

#include "experiments/placement/placement_file.h"
#include "experiments/scene_files/data_files.h"
#include "experiments/scene_files/shape_reader.h"
#include "experiments/scene_files/yaml_value.h"
#include "robots/input_error.h"

namespace b4p {
namespace {

constexpr int kSceneSchema = 1;
constexpr double kFinestStep_m = 1e-5, kCoarsestStep_m = 0.5;
constexpr double kFullTurn_rad = 2.0 * 3.14159265358979323846 + 1e-6;  ///< with room for rounded figures
constexpr const char* kSceneFolder = "experiments/scenes";

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
  for (const YamlValue& item : list.items()) {
    Obstacle obstacle{item["name"].text(), readPlacedShape(item, {"name"})};
    for (const Obstacle& other : obstacles)
      if (other.name == obstacle.name) item["name"].failWithValue("is the name of an earlier obstacle");
    obstacles.push_back(std::move(obstacle));
  }
  return obstacles;
}

void readObject(const YamlValue& object, bool held, Scene& scene) {
  if (held)
    object.allowKeys({"name", "shapes"});
  else
    object.allowKeys({"name", "shapes", "start"});
  scene.object_name = object["name"].text();
  for (const YamlValue& shape : object["shapes"].items()) scene.object.push_back(readPlacedShape(shape, {}));
  if (scene.object.empty()) object["shapes"].fail("is empty");
  if (held) return;
  const YamlValue start = object["start"];
  start.allowKeys({"position_m", "rpy_rad", "quaternion_wxyz"});
  scene.X_WO_start = poseFrom(start);
}

GraspSource readBoxGrasps(const YamlValue& box, double max_opening_m) {
  box.allowKeys({"size_m", "finger_depth_m", "pad_clearance_m"});
  GraspSource source;
  source.family = GraspFamily::kBox;
  source.box_size_m = box["size_m"].positiveVector3(kFarthest_m);
  source.finger_depth_m = box["finger_depth_m"].positive(kFarthest_m);
  source.pad_clearance_m = box["pad_clearance_m"].number(0.0, kFarthest_m);
  const double needed_m = source.box_size_m.minCoeff() + 2.0 * source.pad_clearance_m;
  if (needed_m > max_opening_m)
    box["size_m"].failWithValue("has no pair of faces that fits the gripper's opening of " +
                                std::to_string(max_opening_m) + " m");
  return source;
}

GraspSource readPolygonGrasps(const YamlValue& edges) {
  edges.allowKeys({"polygon_m", "clearance_m"});
  GraspSource source;
  source.family = GraspFamily::kPolygonEdges;
  source.box_size_m.setZero();
  source.polygon_m = readPolygon(edges["polygon_m"]);
  source.pad_clearance_m = edges["clearance_m"].number(0.0, kFarthest_m);
  return source;
}

GraspSource readStickGrasps(const YamlValue& stick, double max_opening_m) {
  stick.allowKeys({"length_m", "radius_m", "margin_m", "finger_depth_m", "pad_clearance_m"});
  GraspSource source;
  source.family = GraspFamily::kStick;
  source.box_size_m.setZero();
  source.stick_length_m = stick["length_m"].positive(kFarthest_m);
  source.stick_radius_m = stick["radius_m"].positive(kFarthest_m);
  source.margin_m = stick["margin_m"].number(0.0, kFarthest_m);
  source.finger_depth_m = stick["finger_depth_m"].positive(kFarthest_m);
  source.pad_clearance_m = stick["pad_clearance_m"].number(0.0, kFarthest_m);
  if (2.0 * source.margin_m > source.stick_length_m)
    stick["margin_m"].failWithValue("leaves nothing of the stick to hold");
  if (source.finger_depth_m > 2.0 * source.stick_radius_m)
    stick["finger_depth_m"].failWithValue("is more than the stick is thick");
  if (2.0 * (source.stick_radius_m + source.pad_clearance_m) > max_opening_m)
    stick["radius_m"].failWithValue("does not fit the gripper's opening of " + std::to_string(max_opening_m) +
                                    " m");
  return source;
}

GraspSource readGrasps(const YamlValue& grasps, double max_opening_m) {
  grasps.allowKeys({"box", "stick", "polygon_edges"});
  if (grasps.entries().size() != 1) grasps.fail("needs exactly one of box, stick and polygon_edges");
  if (const auto box = grasps.find("box")) return readBoxGrasps(*box, max_opening_m);
  if (const auto stick = grasps.find("stick")) return readStickGrasps(*stick, max_opening_m);
  return readPolygonGrasps(grasps["polygon_edges"]);
}

PlacementSource readPlacement(const YamlValue& placement) {
  placement.allowKeys({"region", "upright", "yaw_rad"});
  PlacementSource source;
  const YamlValue region = placement["region"];
  region.allowKeys({"min_m", "max_m"});
  source.min_m = region["min_m"].vector3(kFarthest_m);
  source.max_m = region["max_m"].vector3(kFarthest_m);
  if ((source.max_m - source.min_m).minCoeff() < 0.0) region["max_m"].failWithValue("is less than min_m");
  if (const auto upright = placement.find("upright")) source.upright = upright->boolean();
  if (const auto yaw = placement.find("yaw_rad")) {
    const auto window = yaw->numbers(2);
    if (window[1] < window[0]) yaw->failWithValue("ends before it begins");
    if (window[1] - window[0] > kFullTurn_rad) yaw->failWithValue("is wider than a full turn");
    source.yaw_min_rad = window[0];
    source.yaw_max_rad = window[1];
  }
  return source;
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

void readContact(const YamlValue& document, Scene& scene) {
  const YamlValue clearance = document["contact_clearance_m"];
  scene.contact_clearance_m = clearance.number(0.0, kFarthest_m);
  if (scene.contact_clearance_m < scene.edge_step_m / 2.0)
    clearance.failWithValue("is less than half of edge_step_m, so the object would touch its support");
}

}  // namespace

Scene loadScene(const std::string& name_or_path) {
  const std::string file = shippedFile(kSceneFolder, "scene", name_or_path);
  const YamlValue document = YamlValue::load(file);
  document.requireSchema(kSceneSchema);
  const auto place = document.find("place");
  if (place)
    document.allowKeys(
        {"schema", "name", "robot", "robot_base", "edge_step_m", "budget_s", "obstacles", "object", "place"});
  else
    document.allowKeys({"schema", "name", "robot", "robot_base", "edge_step_m", "contact_clearance_m",
                        "budget_s", "generated", "obstacles", "object", "grasps", "placement"});
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
  readObject(document["object"], place.has_value(), scene);
  if (place) {
    scene.place = readPlacementTask(*place, scene);
    return scene;
  }
  readContact(document, scene);
  scene.grasps = readGrasps(document["grasps"], scene.robot.description.max_opening_m);
  scene.placement = readPlacement(document["placement"]);
  return scene;
}

std::vector<std::string> sceneNames() { return shippedNames(kSceneFolder); }

}  // namespace b4p
