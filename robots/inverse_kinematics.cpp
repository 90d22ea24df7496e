// SPDX-License-Identifier: BSD-3-Clause
#include "robots/inverse_kinematics.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace b4p {
namespace {

constexpr double kTurn_rad = 6.283185307179586476925;

/// Brings a value as far into [lower, upper] as whole turns can, and the rest of the way by clamping. Whether
/// the clamping mattered is for the forward kinematics to say.
double intoLimits(double value, double lower, double upper, bool revolute) {
  if (revolute && (value < lower || value > upper)) {
    const double lowest = value + std::ceil((lower - value) / kTurn_rad) * kTurn_rad;
    // Of the two nearest candidates, one above `lower` and one below it, the nearer to the limits.
    value = lowest <= upper || lowest - upper < lower - (lowest - kTurn_rad) ? lowest : lowest - kTurn_rad;
  }
  return std::clamp(value, lower, upper);
}

/// Angle (rad) of the rotation between two orientations; large when either is no rotation.
double angleBetween(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  const double half_sine = (a - b).norm() / std::sqrt(8.0);
  return 2.0 * std::asin(std::min(1.0, half_sine));
}

}  // namespace

InverseKinematics::InverseKinematics(std::shared_ptr<const Manipulator> robot, IkTolerance tolerance)
    : robot_(std::move(robot)), tolerance_(tolerance) {
  if (!(tolerance_.position_m > 0.0) || !(tolerance_.angle_rad > 0.0))
    throw std::invalid_argument("the tolerances of inverse kinematics have to be positive");
}

bool InverseKinematics::solveFrom(const Eigen::Isometry3d& X_WT, const Eigen::VectorXd& seed,
                                  Eigen::VectorXd& q) {
  if (!X_WT.matrix().allFinite() || seed.size() != robot_->dof() || !seed.allFinite()) return false;
  q.resize(robot_->dof());
  if (!attempt(X_WT, seed, q) || !q.allFinite()) return false;
  for (int i = 0; i < robot_->dof(); ++i) {
    const auto joint = static_cast<std::size_t>(robot_->plannedJoints()[static_cast<std::size_t>(i)]);
    const bool revolute = robot_->model().joints[joint].type == JointType::kRevolute;
    q[i] = intoLimits(q[i], robot_->lower()[i], robot_->upper()[i], revolute);
  }
  const Eigen::Isometry3d reached = robot_->tcpPose(q.data());
  return (reached.translation() - X_WT.translation()).norm() <= tolerance_.position_m &&
         angleBetween(reached.linear(), X_WT.linear()) <= tolerance_.angle_rad;
}

bool InverseKinematics::solve(const Eigen::Isometry3d& X_WT, std::mt19937_64& random, int attempts,
                              Eigen::VectorXd& q) {
  if (!X_WT.matrix().allFinite()) return false;
  Eigen::VectorXd seed(robot_->dof());
  for (int i = 0; i < attempts; ++i) {
    for (int j = 0; j < robot_->dof(); ++j)
      seed[j] = std::uniform_real_distribution<double>(robot_->lower()[j], robot_->upper()[j])(random);
    if (solveFrom(X_WT, seed, q)) return true;
  }
  return false;
}

}  // namespace b4p
