// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "experiments/verification/urdf_reader.h"
#include "robots/manipulator.h"

namespace b4p::verification {

/// Where a robot's links are, computed from its URDF with Eigen alone, and how far they can move. Joints that
/// are neither planned nor fingers stay at the description's rest values, or else at the value in their
/// limits nearest to zero. Immutable; any thread may use it.
class Kinematics {
 public:
  /// @param X_WB  pose of the root link in the world
  /// @throws InputError when the description names a joint or link that the file does not have.
  Kinematics(const std::string& urdf_file, const ManipulatorDescription& description,
             const Eigen::Isometry3d& X_WB);

  const UrdfTree& tree() const { return tree_; }
  int dof() const { return static_cast<int>(planned_.size()); }
  const UrdfJoint& plannedJoint(int i) const { return tree_.joints[planned_[i]]; }
  int tcpLink() const { return tcp_link_; }

  /// Poses of all links at q (dof() values) with the fingers `opening_m` apart, by link index.
  std::vector<Eigen::Isometry3d> linkPoses(const Eigen::VectorXd& q, double opening_m) const;

  /// For each planned joint a bound on how far a point moves (m) per unit of that joint's motion (rad or m),
  /// wherever the other joints stand: for any point at most `radius_m` away from the origin of `link` and
  /// fixed to it. 0 for joints that do not move the link.
  Eigen::VectorXd motionPerUnit(int link, double radius_m) const;

 private:
  double value(int joint, const Eigen::VectorXd& q, double opening_m) const;

  enum Role { kResting = -1, kFinger = -2 };

  UrdfTree tree_;
  Eigen::Isometry3d X_WB_;
  std::vector<int> planned_;  ///< joint indices in the order of q
  std::vector<int> role_;     ///< per joint: index into q, or a Role
  std::vector<double> rest_;  ///< per joint (rad or m)
  int tcp_link_ = -1;
};

}  // namespace b4p::verification
