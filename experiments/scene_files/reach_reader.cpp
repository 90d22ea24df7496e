// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/scene_files/data_files.h"
#include "experiments/scene_files/grasp_table.h"
#include "experiments/scene_files/task_readers.h"

namespace b4p {
namespace {

constexpr double kPositionTolerance_m = 0.05;  ///< of positions, whose orientation is free
constexpr double kHalfTurn_rad = 3.14159265358979323846;

void readPoses(const YamlValue& grasps, const Eigen::Isometry3d& X_WB, ReachTask& task) {
  grasps.allowKeys({"file"});
  const YamlValue file = grasps["file"];
  task.grasp_file = relativeTo(file.file(), file.text());
  for (const Eigen::Isometry3d& X_BT : readGraspTable(task.grasp_file)) task.X_WT.push_back(X_WB * X_BT);
}

void readPositions(const YamlValue& positions, ReachTask& task) {
  task.orientation_free = true;
  task.position_tolerance_m = kPositionTolerance_m;
  for (const YamlValue& position : positions.items())
    task.X_WT.emplace_back(Eigen::Translation3d(position.vector3(kFarthest_m)));
  if (task.X_WT.empty()) positions.fail("is empty");
}

void readTolerance(const YamlValue& tolerance, ReachTask& task) {
  if (task.orientation_free)
    tolerance.allowKeys({"position_m"});
  else
    tolerance.allowKeys({"position_m", "angle_rad", "flip"});
  if (const auto position = tolerance.find("position_m"))
    task.position_tolerance_m = position->positive(kFarthest_m);
  if (const auto angle = tolerance.find("angle_rad"))
    task.angle_tolerance_rad = angle->positive(kHalfTurn_rad);
  if (const auto flip = tolerance.find("flip")) task.flip = flip->boolean();
}

}  // namespace

ReachTask readReachTask(const YamlValue& reach, const Scene& scene) {
  reach.allowKeys({"start", "grasps", "positions_m", "tolerance"});
  ReachTask task;
  task.start = reach["start"].numbers(scene.robot.description.joints.size());
  const auto grasps = reach.find("grasps");
  const auto positions = reach.find("positions_m");
  if (grasps.has_value() == positions.has_value()) reach.fail("needs exactly one of grasps and positions_m");
  if (grasps)
    readPoses(*grasps, scene.X_WB, task);
  else
    readPositions(*positions, task);
  if (const auto tolerance = reach.find("tolerance")) readTolerance(*tolerance, task);
  return task;
}

}  // namespace b4p
