// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "experiments/floating_body.h"
#include "robots/inverse_kinematics.h"

namespace b4p {

/// Straight motions of the TCP that keep its orientation, in steps of 4 cm: along both ways of the hand's own
/// axes, and along the world's axes and the diagonals between them. One object per thread.
class Retreat {
 public:
  /// @param hand  the robot's gripper; outlives this object
  Retreat(std::shared_ptr<const Manipulator> robot, FloatingBody& hand);

  static constexpr int kDirections = 32;

  /// How many steps, at most `steps`, the hand with what it holds can go from X_WT in each direction, looked
  /// at after each step and without the arm. `reach` gets kDirections values.
  void handReach(const Eigen::Isometry3d& X_WT, const Grasp& grasp, int steps, int* reach);

  /// One step in direction 0 ... kDirections-1 from q (dof() values) to `next`: inverse kinematics from q on.
  /// False when there is no answer near q. Collisions are left to the caller.
  bool step(const double* q, int direction, double* next);

 private:
  std::shared_ptr<const Manipulator> robot_;
  FloatingBody& hand_;
  std::unique_ptr<InverseKinematics> kinematics_;
  Eigen::VectorXd seed_, answer_;
  std::vector<int> going_;
  std::vector<Eigen::Vector3d> shifts_m_;
  std::vector<bool> free_;
};

}  // namespace b4p
