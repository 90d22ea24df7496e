// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "robots/inverse_kinematics.h"

namespace b4p {

/// Inverse kinematics of a Franka Panda on a base that slides along two perpendicular directions. An attempt
/// takes base and joint 7 from the seed, a base farther from the target than the arm reaches moved towards
/// it, and answers with the analytic posture (panda_inverse_kinematics.h) nearest to the seed.
///
/// Null unless the robot's chain is two prismatic joints at a right angle, to 1e-9 rad, and then a Panda's,
/// as makePandaInverseKinematics() takes it.
std::unique_ptr<InverseKinematics> makeSlidingPandaInverseKinematics(std::shared_ptr<const Manipulator> robot,
                                                                     IkTolerance tolerance = {});

}  // namespace b4p
