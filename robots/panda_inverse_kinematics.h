// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "robots/inverse_kinematics.h"

namespace b4p {

/// Analytic inverse kinematics of a Franka Panda, with joint 7 as the free parameter. An attempt takes joint
/// 7 from the seed and answers with the posture nearest to the seed; the attempts of one solve() spread
/// their values of joint 7 evenly over its limits.
class PandaInverseKinematics : public InverseKinematics {
 public:
  using InverseKinematics::InverseKinematics;

  /// All answers, at most eight, with joint 7 at `q7` (rad), into `answers` (resized). None for a target or a
  /// value that is not finite or outside its limits. Answers that differ by whole turns count once.
  virtual void solveAll(const Eigen::Isometry3d& X_WT, double q7, std::vector<Eigen::VectorXd>& answers) = 0;
};

/// Null unless the robot's chain from world to TCP is a Panda's: its axes have to be where the Panda has them
/// at q = 0, to a tenth of `tolerance`. The pose of the base and the TCP's place in the hand may be any.
std::unique_ptr<PandaInverseKinematics> makePandaInverseKinematics(std::shared_ptr<const Manipulator> robot,
                                                                   IkTolerance tolerance = {});

}  // namespace b4p
