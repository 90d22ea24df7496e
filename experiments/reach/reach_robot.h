// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>

#include "planners/reach/reach_robot.h"
#include "robots/inverse_kinematics.h"
#include "robots/manipulator.h"

namespace b4p {

/// Makes one thread's inverse kinematics of a robot.
using IkFactory =
    std::function<std::unique_ptr<InverseKinematics>(const std::shared_ptr<const Manipulator>& robot)>;

/// A Manipulator as reach planners see it: forward kinematics and Jacobian through KDL, poses through inverse
/// kinematics from a random seed (makeInverseKinematics() unless another is given), positions by steps of the
/// Jacobian from a random seed, to within a tenth of a millimetre. Immutable.
class ManipulatorReachRobot : public ReachRobot {
 public:
  /// @param robot  not null
  explicit ManipulatorReachRobot(std::shared_ptr<const Manipulator> robot);
  ManipulatorReachRobot(std::shared_ptr<const Manipulator> robot, IkFactory make_ik);

  unsigned dof() const override;
  std::unique_ptr<ReachContext> makeContext() const override;

 private:
  std::shared_ptr<const Manipulator> robot_;
  IkFactory make_ik_;
};

}  // namespace b4p
