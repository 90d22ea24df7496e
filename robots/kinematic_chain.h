// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include <Eigen/Geometry>

#include "robots/manipulator.h"

namespace b4p {

/// Forward kinematics and Jacobian of the TCP through KDL. Holds its own copy of the KDL chain, because a
/// shared one races (its joints cache poses): one object per thread. Cannot be copied.
class KinematicChain {
 public:
  explicit KinematicChain(std::shared_ptr<const Manipulator> robot);
  ~KinematicChain();
  KinematicChain(const KinematicChain&) = delete;
  KinematicChain& operator=(const KinematicChain&) = delete;

  /// Pose X_WT of the TCP at q (dof() values).
  /// @throws std::invalid_argument on non-finite q.
  Eigen::Isometry3d tcpPose(const double* q);

  /// 6 x dof Jacobian of the TCP in world axes, reference point at the TCP's origin: rows 0-2 linear (m per
  /// rad or m), rows 3-5 angular (rad per rad or m).
  /// @throws std::invalid_argument on non-finite q.
  Eigen::MatrixXd jacobian(const double* q);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace b4p
