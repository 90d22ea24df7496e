// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/scene_files/data_files.h"
#include "experiments/scene_files/grasp_table.h"
#include "experiments/scene_files/shape_reader.h"
#include "experiments/scene_files/task_readers.h"

namespace b4p {
namespace {

constexpr double kFullTurn_rad = 2.0 * 3.14159265358979323846 + 1e-6;  ///< with room for rounded figures

void readObject(const YamlValue& object, PickPlaceTask& task) {
  object.allowKeys({"name", "shapes", "start"});
  task.object_name = object["name"].text();
  for (const YamlValue& shape : object["shapes"].items()) task.object.push_back(readPlacedShape(shape, {}));
  if (task.object.empty()) object["shapes"].fail("is empty");
  const YamlValue start = object["start"];
  start.allowKeys({"position_m", "rpy_rad", "quaternion_wxyz"});
  task.X_WO_start = poseFrom(start);
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

GraspSource readListedGrasps(const YamlValue& file, double max_opening_m) {
  GraspSource source;
  source.family = GraspFamily::kListed;
  source.grasp_file = relativeTo(file.file(), file.text());
  source.listed = readHoldingTable(source.grasp_file, max_opening_m);
  return source;
}

GraspSource readGrasps(const YamlValue& grasps, double max_opening_m) {
  grasps.allowKeys({"box", "stick", "polygon_edges", "file"});
  if (grasps.entries().size() != 1) grasps.fail("needs exactly one of box, stick, polygon_edges and file");
  if (const auto box = grasps.find("box")) return readBoxGrasps(*box, max_opening_m);
  if (const auto stick = grasps.find("stick")) return readStickGrasps(*stick, max_opening_m);
  if (const auto file = grasps.find("file")) return readListedGrasps(*file, max_opening_m);
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

}  // namespace

PickPlaceTask readPickPlaceTask(const YamlValue& document, const Scene& scene) {
  PickPlaceTask task;
  const YamlValue clearance = document["contact_clearance_m"];
  task.contact_clearance_m = clearance.number(0.0, kFarthest_m);
  if (task.contact_clearance_m < scene.edge_step_m / 2.0)
    clearance.failWithValue("is less than half of edge_step_m, so the object would touch its support");
  readObject(document["object"], task);
  task.grasps = readGrasps(document["grasps"], scene.robot.description.max_opening_m);
  task.placement = readPlacement(document["placement"]);
  return task;
}

}  // namespace b4p
