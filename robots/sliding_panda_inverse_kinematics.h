// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "robots/inverse_kinematics.h"

namespace b4p {

/// Inverse kinematics of a Franka Panda on a base that slides along two perpendicular directions. An attempt
/// takes the base from the seed, moved towards the target where the arm does not reach from there, and joint
/// 7 from the seed and then from values spread evenly over its limits, until there is an analytic posture
/// (panda_inverse_kinematics.h); the answer is the one nearest to the seed.
///
/// Null unless the robot's chain is two prismatic joints at a right angle, to 1e-9 rad, and then a Panda's,
/// as makePandaInverseKinematics() takes it.
std::unique_ptr<InverseKinematics> makeSlidingPandaInverseKinematics(std::shared_ptr<const Manipulator> robot,
                                                                     IkTolerance tolerance = {});

}  // namespace b4p
