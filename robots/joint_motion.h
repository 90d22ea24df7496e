// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "robots/robot_model.h"

namespace b4p {

/// Pose of the joint's child link in its parent link when the joint has the given value (rad or m).
inline Eigen::Isometry3d childInParent(const Joint& joint, double value) {
  Eigen::Isometry3d X_PC = joint.X_PJ;
  if (joint.type == JointType::kRevolute) X_PC.rotate(Eigen::AngleAxisd(value, joint.axis));
  if (joint.type == JointType::kPrismatic) X_PC.translate(value * joint.axis);
  return X_PC;
}

}  // namespace b4p
