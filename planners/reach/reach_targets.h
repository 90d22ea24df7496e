// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

#include "planners/pick_place_region.h"
#include "planners/reach/reach_robot.h"

namespace b4p {

/// How close the TCP has to come to a grasp.
struct ReachTolerance {
  double position_m = 1e-3;
  double angle_rad = 0.5 * 3.14159265358979323846 / 180.0;
  /// A gripper with two like fingers: the grasp turned by 180 degrees about its approach axis z is the same
  /// one.
  bool flip = true;
};

/// A motion of the TCP, in world axes.
struct TcpTwist {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();   ///< m
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();  ///< rad, along the axis of rotation; 0 where it is free
};

/// In sums of both, a radian counts as much as this many metres.
constexpr double kMetresPerRadian = 0.25;

/// The grasps to choose from: TCP poses, or positions whose orientation is free. Grasp `i` is row i + 1.
/// Immutable; any thread may ask.
class ReachTargets {
 public:
  /// @param X_WT  poses of the TCP in the world
  /// @throws std::invalid_argument for an empty set and tolerances that are not positive and finite; naming
  ///   the row: for a pose that is not finite or whose rotation is off by more than 1e-4
  static ReachTargets poses(const std::vector<Eigen::Isometry3d>& X_WT, const ReachTolerance& tolerance = {});

  /// @param p_WT  positions of the TCP in the world (m)
  /// @throws std::invalid_argument for an empty set, a tolerance that is not positive and finite, and, naming
  ///   the row, a position that is not finite
  static ReachTargets positions(const std::vector<Eigen::Vector3d>& p_WT, double tolerance_m = 0.05);

  std::size_t size() const { return X_WT_.size(); }
  bool positionOnly() const { return position_only_; }
  const ReachTolerance& tolerance() const { return tolerance_; }

  /// @param flipped  turned by 180 degrees about z
  ReachTarget target(GraspId grasp, bool flipped = false) const;

  /// What brings the TCP from X_WT to a grasp or to its flip, whichever takes less turning.
  TcpTwist twistTo(GraspId grasp, const Eigen::Isometry3d& X_WT) const;

  /// How far the TCP at X_WT is from a grasp: metres, and radians times kMetresPerRadian, each beyond its
  /// tolerance. 0 exactly when within().
  double distance(GraspId grasp, const Eigen::Isometry3d& X_WT) const;

  bool within(GraspId grasp, const Eigen::Isometry3d& X_WT) const { return distance(grasp, X_WT) == 0.0; }

 private:
  ReachTargets(std::vector<Eigen::Isometry3d> X_WT, bool position_only, const ReachTolerance& tolerance);

  std::vector<Eigen::Isometry3d> X_WT_;
  bool position_only_;
  ReachTolerance tolerance_;
};

}  // namespace b4p
