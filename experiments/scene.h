// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "experiments/pick_place_task.h"
#include "experiments/placement/placement_task.h"
#include "experiments/reach_task.h"
#include "robots/input_error.h"
#include "robots/manipulator.h"
#include "state_validity/collision_checker.h"

namespace b4p {

/// A robot file (robots/*.yaml): a URDF and how to use it.
struct RobotFile {
  std::string file;       ///< the file read
  std::string urdf_file;  ///< resolved path
  ManipulatorDescription description;
};

/// In the order of Scene::task.
enum class TaskKind { kPickPlace, kReach, kPlacement };

/// As messages call it.
inline std::string nameOf(TaskKind kind) {
  if (kind == TaskKind::kPickPlace) return "pick and place";
  return kind == TaskKind::kReach ? "reaching" : "placement";
}

/// A task with all around it, as its file describes it (experiments/scenes/*.yaml).
struct Scene {
  std::string file;
  std::string name;
  RobotFile robot;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  std::vector<Obstacle> obstacles;
  double edge_step_m = 0.01;
  double budget_s = 10.0;  ///< the scene's usual time limit
  std::variant<PickPlaceTask, ReachTask, PlacementTask> task;

  TaskKind kind() const { return static_cast<TaskKind>(task.index()); }

  /// The task of a scene that has to be one of pick and place. @throws InputError for another
  const PickPlaceTask& pickPlace() const {
    if (const auto* found = std::get_if<PickPlaceTask>(&task)) return *found;
    const bool reach = kind() == TaskKind::kReach;
    throw InputError(file, reach ? "reach" : "place",
                     "is a task of " + nameOf(kind()) + "; one of pick and place is needed here");
  }
  PickPlaceTask& pickPlace() { return const_cast<PickPlaceTask&>(std::as_const(*this).pickPlace()); }

  /// The task of a scene that has to be one of placement. @throws InputError for another
  const PlacementTask& placing() const {
    if (const auto* found = std::get_if<PlacementTask>(&task)) return *found;
    throw InputError(file, "place", "is missing: this is no placement task");
  }
  PlacementTask& placing() { return const_cast<PlacementTask&>(std::as_const(*this).placing()); }
};

/// Loads a scene by path, or by name from the scenes that ship with b4p.
/// @throws InputError naming file, key or row, and value: missing or malformed YAML, unknown or missing key,
///   wrong schema version, wrong type or count, non-finite or out-of-range number, unknown robot, a grasp
///   that is no pose.
Scene loadScene(const std::string& name_or_path);

/// Loads a robot file by path, or by name from those that ship with b4p.
RobotFile loadRobotFile(const std::string& name_or_path);

/// Names of the scenes that ship with b4p, those in a subfolder as FOLDER/NAME.
std::vector<std::string> sceneNames();

}  // namespace b4p
