// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/placement_file.h"

#include <string>
#include <utility>

#include "experiments/placement/point_boxes.h"
#include "experiments/placement/point_cloud.h"
#include "experiments/placement/solid.h"
#include "experiments/scene_files/data_files.h"
#include "experiments/scene_files/shape_reader.h"
#include "robots/input_error.h"

namespace b4p {
namespace {

constexpr const char* kPlacementScenes = "experiments/scenes/placement";
constexpr double kFinestCell_m = 1e-3, kCoarsestCell_m = 0.05;
constexpr double kMostCells = 5e7;

void readVolume(const YamlValue& place, PlacementTask& task) {
  if (const auto cell = place.find("cell_m")) task.cell_m = cell->number(kFinestCell_m, kCoarsestCell_m);
  const YamlValue volume = place["volume"];
  volume.allowKeys({"min_m", "max_m"});
  task.min_m = volume["min_m"].vector3(kFarthest_m);
  task.max_m = volume["max_m"].vector3(kFarthest_m);
  const Eigen::Vector3d size = task.max_m - task.min_m;
  if (size.minCoeff() < 0.0) volume["max_m"].failWithValue("is less than min_m");
  if (size.minCoeff() < task.cell_m)
    volume.fail("is thinner than a cell of " + std::to_string(task.cell_m) + " m");
  if ((size / task.cell_m).prod() > kMostCells)
    volume.fail("has more than 50 million cells of " + std::to_string(task.cell_m) + " m");
}

ClearanceGoal readObjective(const YamlValue& value) {
  if (value.isWord("max_clearance")) return ClearanceGoal::kLargest;
  if (value.isWord("min_clearance")) return ClearanceGoal::kSmallest;
  value.failWithValue("is neither max_clearance nor min_clearance");
}

Eigen::Isometry3d readPose(const YamlValue& pose) {
  pose.allowKeys({"position_m", "rpy_rad", "quaternion_wxyz"});
  return poseFrom(pose);
}

PlacementArm readArm(const YamlValue& entry, const Scene& scene) {
  entry.allowKeys({"name", "robot", "robot_base", "grasp", "start", "rest_opening_m"});
  PlacementArm arm;
  arm.name = entry["name"].text();
  RobotFile robot = scene.robot;
  if (const auto own = entry.find("robot")) {
    const std::string name = own->text();
    robot = loadRobotFile(isPath(name) ? relativeTo(scene.file, name) : name);
  }
  arm.robot_file = robot.file;
  arm.urdf_file = robot.urdf_file;
  arm.description = robot.description;
  const auto base = entry.find("robot_base");
  arm.X_WB = base ? readPose(*base) : scene.X_WB;
  const YamlValue grasp = entry["grasp"];
  grasp.allowKeys({"position_m", "rpy_rad", "quaternion_wxyz", "opening_m"});
  arm.grasp.X_OT = poseFrom(grasp);
  arm.grasp.opening_m = grasp["opening_m"].number(0.0, robot.description.max_opening_m);
  arm.start = entry["start"].numbers(robot.description.joints.size());
  const auto rest_opening = entry.find("rest_opening_m");
  arm.rest_opening_m = rest_opening ? rest_opening->number(0.0, robot.description.max_opening_m)
                                    : robot.description.max_opening_m;
  return arm;
}

void readObject(const YamlValue& object, PlacementTask& task) {
  object.allowKeys({"name", "shapes"});
  task.object_name = object["name"].text();
  for (const YamlValue& shape : object["shapes"].items()) task.object.push_back(readPlacedShape(shape, {}));
  if (task.object.empty()) object["shapes"].fail("is empty");
}

void addPoints(const YamlValue& points, const PlacementTask& task, Scene& scene) {
  points.allowKeys({"name", "file"});
  const std::string name = points["name"].text();
  try {
    const auto cloud = readPointCloud(relativeTo(scene.file, points["file"].text()));
    for (Obstacle& box : boxesAround(cloud, task.min_m, task.cell_m, name))
      scene.obstacles.push_back(std::move(box));
  } catch (const InputError& e) {
    points.fail(e.what());
  }
}

}  // namespace

PlacementTask readPlacementTask(const YamlValue& place, const YamlValue& object, Scene& scene) {
  place.allowKeys({"volume", "objective", "centre_of_mass_m", "cell_m", "points", "arms"});
  PlacementTask task;
  readObject(object, task);
  readVolume(place, task);
  if (scene.edge_step_m >= task.cell_m)
    place.fail("edge_step_m (" + std::to_string(scene.edge_step_m) + ") has to be less than a cell (" +
               std::to_string(task.cell_m) + " m), or the object would touch what it stands on");
  task.objective = readObjective(place["objective"]);
  const auto com = place.find("centre_of_mass_m");
  task.p_OCom = com ? com->vector3(kFarthest_m) : centreOfMass(task.object);
  if (const auto points = place.find("points")) addPoints(*points, task, scene);
  for (const YamlValue& entry : place["arms"].items()) {
    PlacementArm arm = readArm(entry, scene);
    for (const PlacementArm& earlier : task.arms)
      if (earlier.name == arm.name) entry["name"].failWithValue("is the name of two arms");
    task.arms.push_back(std::move(arm));
    if (task.arms.back().start.size() != task.arms.front().start.size())
      entry["start"].fail("has another number of joints than the first arm");
  }
  if (task.arms.empty()) place["arms"].fail("is empty");
  return task;
}

Scene loadPlacementScene(const std::string& name_or_path) {
  Scene scene = loadScene(name_or_path);
  scene.placing();
  return scene;
}

std::vector<std::string> placementSceneNames() {
  std::vector<std::string> names = shippedNames(kPlacementScenes);
  for (std::string& name : names) name = "placement/" + name;
  return names;
}

}  // namespace b4p
