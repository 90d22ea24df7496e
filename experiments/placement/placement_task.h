// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "experiments/placement/clearance_objective.h"
#include "robots/grasp.h"
#include "robots/manipulator.h"
#include "robots/shape.h"

namespace b4p {

/// An arm that holds the object at the start, if it is the arm that is chosen. Otherwise it stays there with
/// an empty hand, an obstacle to the others.
struct PlacementArm {
  std::string name;
  std::string robot_file;  ///< named in errors
  std::string urdf_file;
  ManipulatorDescription description;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  Grasp grasp;
  std::vector<double> start;    ///< joint values (rad or m); where the arm rests while another moves
  double rest_opening_m = 0.0;  ///< of its empty hand, while another arm moves
};

/// What a placement scene (experiments/scenes/placement/*.yaml) asks for beyond obstacles and object.
struct PlacementTask {
  std::string object_name;
  std::vector<PlacedShape> object;  ///< in O
  Eigen::Vector3d min_m, max_m;     ///< target volume, in the world; not empty
  ClearanceGoal objective = ClearanceGoal::kLargest;
  Eigen::Vector3d p_OCom = Eigen::Vector3d::Zero();  ///< centre of mass
  double cell_m = 0.005;                             ///< of the occupancy grid
  std::vector<PlacementArm> arms;                    ///< at least one
};

}  // namespace b4p
