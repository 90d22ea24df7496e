// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/placement/placement_task.h"
#include "robots/grasp.h"
#include "robots/manipulator.h"
#include "state_validity/collision_checker.h"

namespace b4p {

/// A robot file (robots/*.yaml): a URDF and how to use it.
struct RobotFile {
  std::string file;       ///< the file read
  std::string urdf_file;  ///< resolved path
  ManipulatorDescription description;
};

enum class GraspFamily {
  kPolygonEdges,  ///< planar robot: one grasp per polygon edge, at its midpoint, along the inward normal
  kBox,           ///< parallel gripper on a box: pads on two opposite faces no farther apart than the opening
  kStick,         ///< parallel gripper across a round stick, anywhere along it, from any side
};

/// How grasps are drawn.
struct GraspSource {
  GraspFamily family = GraspFamily::kBox;
  std::vector<Eigen::Vector2d> polygon_m;  ///< kPolygonEdges: outline, counter-clockwise, in the object frame
  Eigen::Vector3d box_size_m =
      Eigen::Vector3d::Zero();   ///< kBox: sizes of the box that is grasped, centred in O
  double stick_length_m = 0.0;   ///< kStick: along the z axis of O, its middle in O's origin
  double stick_radius_m = 0.0;   ///< kStick
  double margin_m = 0.0;         ///< kStick: how far the TCP stays from the stick's ends
  double finger_depth_m = 0.0;   ///< kBox: how far the TCP reaches past the face it approaches through;
                                 ///< kStick: past the side of the stick it approaches from
  double pad_clearance_m = 0.0;  ///< gap left between the object and each pad (or the gripper's front)
};

/// Where the object's origin may come to rest, in the world.
struct PlacementSource {
  Eigen::Vector3d min_m, max_m;  ///< box of positions
  bool upright = false;          ///< z of O is vertical at the end
  double yaw_min_rad = -3.14159265358979323846;
  double yaw_max_rad = 3.14159265358979323846;  ///< orientation: R_start_upright turned about the world z by
                                                ///< a yaw in this window
};

/// A pick-and-place task as its file describes it (experiments/scenes/*.yaml).
struct Scene {
  std::string file;
  std::string name;
  RobotFile robot;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  std::vector<Obstacle> obstacles;
  std::string object_name;
  std::vector<PlacedShape> object;  ///< in O
  Eigen::Isometry3d X_WO_start = Eigen::Isometry3d::Identity();
  GraspSource grasps;
  PlacementSource placement;
  std::optional<PlacementTask> place;  ///< in place of start pose, grasps and placement
  double edge_step_m = 0.01;
  double contact_clearance_m = 0.0;  ///< the least distance of the held object from obstacles at the start
                                     ///< pose; preflight() checks it
  double budget_s = 10.0;            ///< the scene's usual time limit
};

/// Loads a scene by path, or by name from the scenes that ship with b4p.
/// @throws InputError naming file, key and value: missing or malformed YAML, unknown or missing key, wrong
///   schema version, wrong type or count, non-finite or out-of-range number, unknown robot.
Scene loadScene(const std::string& name_or_path);

/// Loads a robot file by path, or by name from those that ship with b4p.
RobotFile loadRobotFile(const std::string& name_or_path);

/// Names of the scenes that ship with b4p.
std::vector<std::string> sceneNames();

}  // namespace b4p
