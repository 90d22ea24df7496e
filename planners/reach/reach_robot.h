// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <random>

#include <Eigen/Geometry>

namespace b4p {

using TcpJacobian = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// Where the TCP is to be: frame T in the world W, z being the approach axis.
struct ReachTarget {
  Eigen::Isometry3d X_WT;
  bool position_only = false;  ///< the orientation is free
};

/// One thread's access to a ReachRobot. q arrays hold dof() values, finite and inside the joint limits.
class ReachContext {
 public:
  virtual ~ReachContext() = default;

  /// Pose X_WT of the TCP at q.
  virtual Eigen::Isometry3d tcpPose(const double* q) = 0;

  /// Jacobian of the TCP in world axes, 6 x dof: rows 0-2 linear (m per rad or m), 3-5 angular (rad per rad
  /// or m).
  virtual TcpJacobian jacobian(const double* q) = 0;

  /// One attempt of inverse kinematics, with all its chance taken from `random`. True: `q` holds an answer
  /// inside the joint limits. False: this attempt found none, another may.
  virtual bool inverse(const ReachTarget& target, std::mt19937_64& random, double* q) = 0;
};

/// What reaching needs to know of a robot. Shared by all threads; each thread takes its own context. An
/// exception out of a context ends the search that asked with PlannerStatus::CRASH.
class ReachRobot {
 public:
  virtual ~ReachRobot() = default;
  virtual unsigned dof() const = 0;
  virtual std::unique_ptr<ReachContext> makeContext() const = 0;
};

}  // namespace b4p
