// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "experiments/result.h"

namespace b4p {

/// Outcome of re-checking a placement by code that shares nothing with the planner's checks.
struct PlacementVerification : Verification {
  double objective_m = 0.0;  ///< recomputed from the shapes
  double gap_m = 0.0;        ///< the largest below a foot of the object
};

/// A motion to a placement better than those before.
struct PlacementImprovement {
  double time_s = 0.0;  ///< since planning began
  double cpu_s = 0.0;   ///< processor time of the process since then
  double objective_m = 0.0;
  int arm = -1;                                            ///< number in the scene's list
  std::vector<std::vector<double>> path;                   ///< way-points, one value per joint (rad or m)
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();  ///< of the object at the end
  PlacementVerification verification;
};

}  // namespace b4p
