// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include <Eigen/Core>

#include "robots/inverse_kinematics.h"

namespace b4p {

/// Straight motions of the TCP that keep its orientation, in steps: along both ways of the hand's own axes,
/// and along the world's axes and the diagonals between them. One object per thread.
class Retreat {
 public:
  explicit Retreat(std::shared_ptr<const Manipulator> robot);

  static constexpr int kDirections = 32;

  /// One step of 4 cm in direction 0 ... kDirections-1 from q (dof() values) to `next`: inverse kinematics
  /// from q on. False when there is no answer near q.
  bool step(const double* q, int direction, double* next);

 private:
  std::shared_ptr<const Manipulator> robot_;
  std::unique_ptr<InverseKinematics> kinematics_;
  Eigen::VectorXd seed_, answer_;
};

}  // namespace b4p
