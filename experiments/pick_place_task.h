// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "robots/grasp.h"
#include "robots/shape.h"

namespace b4p {

enum class GraspFamily {
  kPolygonEdges,  ///< planar robot: one grasp per polygon edge, at its midpoint, along the inward normal
  kBox,           ///< parallel gripper on a box: pads on two opposite faces no farther apart than the opening
  kStick,         ///< parallel gripper across a round stick, anywhere along it, from any side
  kListed,        ///< those listed, whatever they hold
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
  std::vector<Grasp> listed;     ///< kListed
  std::string grasp_file;        ///< kListed: where they come from, row by row
};

/// Where the object's origin may come to rest, in the world.
struct PlacementSource {
  Eigen::Vector3d min_m, max_m;  ///< box of positions
  bool upright = false;          ///< z of O is vertical at the end
  double yaw_min_rad = -3.14159265358979323846;
  double yaw_max_rad = 3.14159265358979323846;  ///< orientation: R_start_upright turned about the world z by
                                                ///< a yaw in this window
};

/// Take an object from where it stands and put it down somewhere in a region.
struct PickPlaceTask {
  std::string object_name;
  std::vector<PlacedShape> object;  ///< in O
  Eigen::Isometry3d X_WO_start = Eigen::Isometry3d::Identity();
  GraspSource grasps;
  PlacementSource placement;
  double contact_clearance_m = 0.0;  ///< the least distance of the held object from obstacles at the start
                                     ///< pose; preflight() checks it
};

}  // namespace b4p
