// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <random>

#include <Eigen/Geometry>

#include "robots/joint_limits.h"
#include "robots/manipulator.h"

namespace b4p {

/// How close an answer's forward kinematics must come to the target.
struct IkTolerance {
  double position_m = 1e-4;
  double angle_rad = 1e-3;
};

/// Inverse kinematics of the TCP. One object per thread.
///
/// Whatever the solver behind it, an answer given here lies inside the joint limits (revolute joints are
/// wrapped by 2 pi into them where that helps) and its forward kinematics meet the tolerance: both are
/// checked in this class.
class InverseKinematics {
 public:
  InverseKinematics(std::shared_ptr<const Manipulator> robot, IkTolerance tolerance);
  virtual ~InverseKinematics() = default;
  InverseKinematics(const InverseKinematics&) = delete;
  InverseKinematics& operator=(const InverseKinematics&) = delete;

  /// One attempt from `seed` (dof() values). True: `q` (resized) is an answer. False: nothing found, or a
  /// non-finite target or seed; `q` is then unspecified.
  bool solveFrom(const Eigen::Isometry3d& X_WT, const Eigen::VectorXd& seed, Eigen::VectorXd& q);

  /// Up to `attempts` attempts from seeds drawn uniformly inside the limits with `random`.
  bool solve(const Eigen::Isometry3d& X_WT, std::mt19937_64& random, int attempts, Eigen::VectorXd& q);

  const Manipulator& robot() const { return *robot_; }
  const IkTolerance& tolerance() const { return tolerance_; }

 protected:
  /// The solver's own attempt; `q` has dof() values. Its answer need not respect limits or tolerance.
  virtual bool attempt(const Eigen::Isometry3d& X_WT, const Eigen::VectorXd& seed, Eigen::VectorXd& q) = 0;

  /// The seed of attempt 0, 1, ... of one solve(). `seed` holds the one before.
  virtual void drawSeed(std::mt19937_64& random, int attempt, Eigen::VectorXd& seed);

  /// Brings `q` inside the limits; true when it is then an answer.
  bool accept(const Eigen::Isometry3d& X_WT, Eigen::VectorXd& q) const;

  const JointLimits& limits() const { return limits_; }

 private:
  std::shared_ptr<const Manipulator> robot_;
  IkTolerance tolerance_;
  JointLimits limits_;
  Eigen::VectorXd seed_;
};

/// The reference: KDL's Levenberg-Marquardt solver (ChainIkSolverPos_LMA) on a chain of its own.
std::unique_ptr<InverseKinematics> makeKdlInverseKinematics(std::shared_ptr<const Manipulator> robot,
                                                            IkTolerance tolerance = {});

/// Damped least squares that stay inside the limits, for any robot.
std::unique_ptr<InverseKinematics> makeDampedInverseKinematics(std::shared_ptr<const Manipulator> robot,
                                                               IkTolerance tolerance = {});

/// The fastest there is for the robot: the analytic one (panda_inverse_kinematics.h) for a Panda, whatever
/// its base and its tool, also where it slides (sliding_panda_inverse_kinematics.h), else damped least
/// squares.
std::unique_ptr<InverseKinematics> makeInverseKinematics(std::shared_ptr<const Manipulator> robot,
                                                         IkTolerance tolerance = {});

}  // namespace b4p
