// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>

#include "planners/reach/reach_robot.h"
#include "robots/inverse_kinematics.h"
#include "robots/manipulator.h"
#include "state_validity/collision_checker.h"

namespace b4p {

/// Makes one thread's inverse kinematics of a robot.
using IkFactory =
    std::function<std::unique_ptr<InverseKinematics>(const std::shared_ptr<const Manipulator>& robot)>;

/// A Manipulator as reach planners see it: forward kinematics and Jacobian through KDL, poses through inverse
/// kinematics from a random seed (makeInverseKinematics() unless another is given), positions by steps of the
/// Jacobian from a random seed, to within a tenth of a millimetre. Given a checker of the hand, it asks for
/// no inverse kinematics where the open hand alone collides, which costs a fraction of it. Immutable.
class ManipulatorReachRobot : public ReachRobot {
 public:
  /// @param robot  not null
  explicit ManipulatorReachRobot(std::shared_ptr<const Manipulator> robot);
  ManipulatorReachRobot(std::shared_ptr<const Manipulator> robot, IkFactory make_ik);

  /// @param hand  of FloatingBody::Parts::kGripper, without an object
  ManipulatorReachRobot(std::shared_ptr<const Manipulator> robot,
                        std::shared_ptr<const CollisionChecker> hand);

  unsigned dof() const override;
  std::unique_ptr<ReachContext> makeContext() const override;

 private:
  std::shared_ptr<const Manipulator> robot_;
  IkFactory make_ik_;
  std::shared_ptr<const CollisionChecker> hand_;  ///< or nullptr
};

}  // namespace b4p
