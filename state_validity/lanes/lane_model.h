// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "state_validity/fcl_world.h"
#include "state_validity/lanes/lane_world.h"

namespace b4p::lanes {

/// A world in the form that checks many configurations at a time. Immutable, shared by all threads.
class LaneModel {
 public:
  explicit LaneModel(const FclWorld& world);

  const LaneWorld& lanes() const { return lanes_; }

  /// What moves with the gripper open by opening_m. @param X_TO  pose of the carried object in the TCP's
  /// frame; nullptr: nothing is carried
  LaneRobot robot(const FclWorld& world, double opening_m, const Eigen::Isometry3d* X_TO) const;

  /// Joint values (m) of prismatic joints beyond which rounding exceeds what the bodies' margins allow for.
  static constexpr double kLongestSlide_m = 16.0;

  /// False when a joint value is out of the range in which the bodies' margins hold.
  bool covers(const double* q) const;

  /// Names of bodies that are known by their bounding box only, separated by commas; empty: none.
  const std::string& coarse() const { return coarse_; }

 private:
  // A link's pose in the joint frame that carries it.
  struct Carried {
    int joint;
    Eigen::Isometry3d X_JL;
  };
  // What rounding may do to a joint's moved frame: an angle (rad) and a distance (m); how far it may be from
  // the origin.
  struct Error {
    double angle = 0.0;
    double place_m = 0.0;
    double farthest_m = 0.0;
  };

  std::vector<Carried> carriedLinks(const Manipulator& robot, double opening_m) const;
  LaneBody body(const Piece& piece, int joint, const Eigen::Isometry3d& X_JS) const;
  void addJoints(const Manipulator& robot);
  void addStill(const FclWorld& world);

  LaneWorld lanes_;
  std::vector<int> lane_joint_;                          ///< by model joint; -1: not planned
  std::vector<Eigen::Isometry3d> X_joint_link_;          ///< by lane joint: its link in its moved frame
  std::vector<Error> errors_;                            ///< by lane joint
  std::vector<int> slides_;                              ///< indices into q of prismatic joints
  std::vector<std::shared_ptr<const LaneMesh>> meshes_;  ///< by piece
  std::string coarse_;
};

}  // namespace b4p::lanes
