// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include <Eigen/Geometry>

#include "robots/manipulator.h"

namespace b4p {

/// A robot whose seven joints are placed as those of a Franka Panda, in its world and with its tool.
///
/// Frames: S, the shoulder: axis 1 is z, axis 2 is y, and they meet in the origin. 7: the maker's frame of
/// link 7, z along axis 7, turning with it.
struct PandaArm {
  using Joints = std::array<double, 7>;  ///< values of joints 1 to 7 (rad), from the base on

  Eigen::Isometry3d X_SW;
  Eigen::Isometry3d X_T7;
  std::array<int, 7> q_index;  ///< per joint: its place in q
  Joints lower, upper;

  /// Nothing unless the robot moves as a Panda does: every axis within `tolerance_m`, and within the same
  /// in rad, of where the Panda has it at q = 0. Where the robot's description puts its frames does not
  /// matter.
  static std::optional<PandaArm> recognise(const Manipulator& robot, double tolerance_m);

  /// All postures, up to whole turns, that put frame 7 at X_S7 with joint 7 at q7 and lie inside the limits
  /// but for rounding.
  struct Postures {
    std::array<Joints, 8> at;
    int count = 0;
  };
  Postures postures(const Eigen::Isometry3d& X_S7, double q7) const;
};

}  // namespace b4p
