// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

namespace b4p {

/// How an object is held: pose of the TCP in the object's frame O, and the distance between the finger pads.
struct Grasp {
  Eigen::Isometry3d X_OT = Eigen::Isometry3d::Identity();
  double opening_m = 0.0;  ///< in [0, max_opening_m]
};

}  // namespace b4p
