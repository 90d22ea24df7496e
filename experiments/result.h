// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "robots/grasp.h"

namespace b4p {

/// Outcome of re-checking a path by code that shares nothing with the checker that planned it.
struct Verification {
  bool passed = false;
  std::string failure;            ///< first thing found wrong, one line; empty when passed
  double step_m = 0.0;            ///< largest swept motion between two checked configurations (m)
  long configurations = 0;        ///< how many were checked
  double clearance_m = 0.0;       ///< smallest distance seen between things that may not touch (m)
};

/// A planned motion as it is written to a file (JSON).
struct PlanResult {
  std::string scene;       ///< name or path, as loadScene() takes it
  std::string planner;
  std::map<std::string, std::string> parameters;
  std::uint64_t seed = 0;
  unsigned threads = 1;
  double time_limit_s = 0.0;
  double planning_time_s = 0.0;
  std::string status;      ///< OMPL's name of the planner status
  bool solved = false;     ///< an exact path was found
  int grasp_id = -1;
  Grasp grasp;
  Eigen::Isometry3d X_WO_pick = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d X_WO_place = Eigen::Isometry3d::Identity();
  std::vector<std::string> joint_names;
  std::vector<std::vector<double>> path;  ///< way-points, one value per joint (rad or m)
  Verification verification;
};

/// Writes atomically (a temporary file, then a rename). @throws InputError if the place cannot be written.
void writeResult(const std::string& file, const PlanResult& result);

/// @throws InputError naming file and element: unreadable, cut off, wrong schema version, missing key, wrong
///   type, non-finite value, rows of different length.
PlanResult readResult(const std::string& file);

}  // namespace b4p
