// SPDX-License-Identifier: BSD-3-Clause
#include "robots/joint_limits.h"

namespace b4p {

JointLimits::JointLimits(const Manipulator& robot) {
  for (int i = 0; i < robot.dof(); ++i) {
    const auto joint = static_cast<std::size_t>(robot.plannedJoints()[static_cast<std::size_t>(i)]);
    limits_.push_back(
        {robot.lower()[i], robot.upper()[i], robot.model().joints[joint].type == JointType::kRevolute});
  }
}

double JointLimits::turned(const Limit& limit, double value) {
  constexpr double kTurn_rad = 6.283185307179586476925;
  const double lowest = value + std::ceil((limit.lower - value) / kTurn_rad) * kTurn_rad;
  // Of the two nearest candidates, one above the lower limit and one below it, the nearer to the limits.
  const bool lowest_is_nearer = lowest - limit.upper < limit.lower - (lowest - kTurn_rad);
  return lowest <= limit.upper || lowest_is_nearer ? lowest : lowest - kTurn_rad;
}

}  // namespace b4p
