// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "robots/grasp.h"

namespace b4p {

/// Outcome of re-checking a path by code that shares nothing with the checker that planned it.
struct Verification {
  bool passed = false;
  std::string failure;  ///< first thing found wrong, one line; empty when passed
  double step_m = 0.0;  ///< largest swept motion between two samples of an edge (m)
  /// Samples covered: each pair of bodies was measured there, or known to be apart from an earlier sample.
  long configurations = 0;
  double clearance_m = 0.0;  ///< smallest distance at any sample between things that may not touch (m)
};

/// A planned motion as it is written to a file (JSON): of an object, held with `grasp` all the way, or of the
/// empty hand to a grasp, where X_WT_reached stands in place of `grasp` and the object's poses.
struct PlanResult {
  std::string scene;  ///< name or path, as loadScene() takes it
  std::string planner;
  std::string checker = "fcl";  ///< see checkerNamed(); of files that do not say, FCL
  std::map<std::string, std::string> parameters;
  std::uint64_t seed = 0;
  unsigned threads = 1;
  double time_limit_s = 0.0;
  double planning_time_s = 0.0;
  std::string status;   ///< OMPL's name of the planner status
  bool solved = false;  ///< an exact path was found
  int grasp_id = -1;    ///< of the grasp held, or reached: row grasp_id + 1 of the scene's grasps
  Grasp grasp;
  Eigen::Isometry3d X_WO_pick = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d X_WO_place = Eigen::Isometry3d::Identity();
  std::optional<Eigen::Isometry3d> X_WT_reached;  ///< where the TCP is at the path's end
  std::vector<std::string> joint_names;
  std::vector<std::vector<double>> path;  ///< way-points, one value per joint (rad or m)
  Verification verification;
};

/// Writes UTF-8 JSON as writeFile() does. Poses are written as position and rotation matrix, and every number
/// with the digits that read back to the same bits.
/// @throws InputError if the place cannot be written; std::invalid_argument if a number is not finite, since
///   readResult() would refuse the file.
void writeResult(const std::string& file, const PlanResult& result);

/// @throws InputError naming file and element: unreadable, cut off or malformed, wrong schema version; a
///   key that is missing, unknown or repeated; a value of the wrong type, out of range or not finite;
///   way-points that differ in length from the joint names.
PlanResult readResult(const std::string& file);

}  // namespace b4p
