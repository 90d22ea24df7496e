// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "robots/manipulator.h"

namespace b4p {

/// A robot from the world to its TCP, made ready for fast kinematics: what is fixed between two moving joints
/// is merged, and every joint's frame is turned so that its axis is z. Immutable, shared by all threads.
class AlignedChain {
 public:
  struct MovingJoint {
    Eigen::Isometry3d X_PJ;  ///< joint frame in the moved frame of the joint before it, or in the world
    bool revolute;           ///< else prismatic
    int q_index;             ///< place of its value in q
  };

  explicit AlignedChain(const Manipulator& robot);

  /// From the root to the TCP.
  const std::vector<MovingJoint>& joints() const { return joints_; }

  /// Pose X_WT of the TCP at q, and the 6 x dof Jacobian: world axes, reference point at the TCP's origin,
  /// rows 0-2 linear, rows 3-5 angular, one column per entry of q. No check of q. Reentrant.
  template <typename Jacobian>
  Eigen::Isometry3d tcpPose(const double* q, Jacobian& jacobian) const;

  /// Poses of the joint frames in the world at q, each before its own motion, and of the TCP after them.
  std::vector<Eigen::Isometry3d> frames(const double* q) const;

 private:
  static void move(const MovingJoint& joint, double value, Eigen::Isometry3d& X_WJ) {
    if (!joint.revolute) {
      X_WJ.translation() += value * X_WJ.linear().col(2);
      return;
    }
    const double c = std::cos(value), s = std::sin(value);
    const Eigen::Vector3d x = X_WJ.linear().col(0), y = X_WJ.linear().col(1);
    X_WJ.linear().col(0) = c * x + s * y;
    X_WJ.linear().col(1) = c * y - s * x;
  }

  std::vector<MovingJoint> joints_;
  Eigen::Isometry3d X_LT_;  ///< TCP in the moved frame of the last joint
};

template <typename Jacobian>
Eigen::Isometry3d AlignedChain::tcpPose(const double* q, Jacobian& jacobian) const {
  Eigen::Isometry3d X_W = Eigen::Isometry3d::Identity();
  for (const MovingJoint& joint : joints_) {
    X_W = X_W * joint.X_PJ;
    // A joint's origin waits in its column until the TCP is known.
    jacobian.col(joint.q_index) << X_W.translation(), X_W.linear().col(2);
    move(joint, q[joint.q_index], X_W);
  }
  const Eigen::Isometry3d X_WT = X_W * X_LT_;
  for (const MovingJoint& joint : joints_) {
    auto column = jacobian.col(joint.q_index);
    const Eigen::Vector3d origin = column.template head<3>(), axis = column.template tail<3>();
    if (joint.revolute)
      column.template head<3>() = axis.cross(X_WT.translation() - origin);
    else
      column << axis, Eigen::Vector3d::Zero();
  }
  return X_WT;
}

}  // namespace b4p
