// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "robots/robot_model.h"

namespace b4p {

/// What a URDF does not say about using a robot to carry things.
struct ManipulatorDescription {
  std::vector<std::string> joints;  ///< planned joints, in the order of q
  std::string tcp_link;             ///< frame T: origin between the fingers, z = approach, y = closing axis
  std::vector<std::string> finger_joints;  ///< each set to half the gripper's opening; may be empty
  std::vector<std::string> finger_links;   ///< links that may touch the held object; may be empty
  double max_opening_m = 0.0;              ///< largest distance between the finger pads
  /// Pairs of links whose contact is not a collision. Links joined by one joint are always skipped.
  std::vector<std::pair<std::string, std::string>> skip_self_collision;
  /// Values (rad or m) of joints that are neither planned nor fingers: the arm that rests while another
  /// moves. Those not named stay at the value in their limits nearest to zero.
  std::map<std::string, double> rest;
};

/// A robot made ready for planning: names resolved, base placed in the world. Immutable, shared
/// by all threads. Joints that are neither planned nor fingers stay at their rest values.
class Manipulator {
 public:
  /// @param X_WB    pose of the root link in the world
  /// @param source  named in errors
  /// @throws InputError for names that do not exist, a planned joint that is fixed or not between
  ///   root and TCP, a moving joint between root and TCP that is not planned, a duplicate, a rest value of a
  ///   joint that is fixed, planned or a finger, or outside its limits.
  Manipulator(RobotModel model, ManipulatorDescription description, const Eigen::Isometry3d& X_WB,
              const std::string& source);

  const RobotModel& model() const { return model_; }
  const ManipulatorDescription& description() const { return description_; }
  const Eigen::Isometry3d& X_WB() const { return X_WB_; }

  int dof() const { return static_cast<int>(planned_.size()); }
  const std::vector<int>& plannedJoints() const { return planned_; }  ///< indices into model().joints
  /// Value (rad or m) of a joint (index into model().joints) while it is neither planned nor a finger.
  double restValue(int joint) const { return rest_[static_cast<std::size_t>(joint)]; }
  int tcpLink() const { return tcp_link_; }
  const std::vector<int>& fingerLinks() const { return finger_links_; }
  const Eigen::VectorXd& lower() const { return lower_; }  ///< rad or m, size dof()
  const Eigen::VectorXd& upper() const { return upper_; }

  /// Poses X_WL of all links at q (dof() values) and gripper opening (m), into `X_WL` (resized). Reentrant.
  void linkPoses(const double* q, double opening_m, std::vector<Eigen::Isometry3d>& X_WL) const;

  /// Pose X_WT of the TCP at q. Reentrant.
  Eigen::Isometry3d tcpPose(const double* q) const;

  /// True when all dof() values are finite and inside the limits (inclusive).
  bool withinLimits(const double* q) const;

 private:
  RobotModel model_;
  ManipulatorDescription description_;
  Eigen::Isometry3d X_WB_;
  std::vector<int> planned_;
  std::vector<int> joint_source_;  ///< per model joint: >= 0 index into q, -1 constant, -2 finger
  std::vector<double> rest_;       ///< per model joint: value used when constant
  std::vector<int> finger_links_;
  int tcp_link_ = -1;
  Eigen::VectorXd lower_, upper_;
};

}  // namespace b4p
