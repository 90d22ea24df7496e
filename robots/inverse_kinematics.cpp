// SPDX-License-Identifier: BSD-3-Clause
#include "robots/inverse_kinematics.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "robots/panda_inverse_kinematics.h"
#include "robots/sliding_panda_inverse_kinematics.h"

namespace b4p {
namespace {

/// Angle (rad) of the rotation between two orientations; large when either is no rotation.
double angleBetween(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  const double half_sine = (a - b).norm() / std::sqrt(8.0);
  return 2.0 * std::asin(std::min(1.0, half_sine));
}

}  // namespace

InverseKinematics::InverseKinematics(std::shared_ptr<const Manipulator> robot, IkTolerance tolerance)
    : robot_(std::move(robot)), tolerance_(tolerance), limits_(*robot_), seed_(robot_->dof()) {
  if (!(tolerance_.position_m > 0.0) || !(tolerance_.angle_rad > 0.0))
    throw std::invalid_argument("the tolerances of inverse kinematics have to be positive");
}

bool InverseKinematics::solveFrom(const Eigen::Isometry3d& X_WT, const Eigen::VectorXd& seed,
                                  Eigen::VectorXd& q) {
  if (!X_WT.matrix().allFinite() || seed.size() != robot_->dof() || !seed.allFinite()) return false;
  q.resize(robot_->dof());
  return attempt(X_WT, seed, q) && accept(X_WT, q);
}

bool InverseKinematics::solve(const Eigen::Isometry3d& X_WT, std::mt19937_64& random, int attempts,
                              Eigen::VectorXd& q) {
  for (int i = 0; i < attempts; ++i) {
    drawSeed(random, i, seed_);
    if (solveFrom(X_WT, seed_, q)) return true;
  }
  return false;
}

bool InverseKinematics::accept(const Eigen::Isometry3d& X_WT, Eigen::VectorXd& q) const {
  if (!q.allFinite()) return false;
  for (int i = 0; i < robot_->dof(); ++i) q[i] = limits_.bringInside(i, q[i]);
  const Eigen::Isometry3d reached = robot_->tcpPose(q.data());
  return (reached.translation() - X_WT.translation()).norm() <= tolerance_.position_m &&
         angleBetween(reached.linear(), X_WT.linear()) <= tolerance_.angle_rad;
}

void InverseKinematics::drawSeed(std::mt19937_64& random, int, Eigen::VectorXd& seed) {
  for (int i = 0; i < robot_->dof(); ++i)
    seed[i] = std::uniform_real_distribution<double>(robot_->lower()[i], robot_->upper()[i])(random);
}

std::unique_ptr<InverseKinematics> makeInverseKinematics(std::shared_ptr<const Manipulator> robot,
                                                         IkTolerance tolerance) {
  if (auto analytic = makePandaInverseKinematics(robot, tolerance)) return analytic;
  if (auto sliding = makeSlidingPandaInverseKinematics(robot, tolerance)) return sliding;
  return makeDampedInverseKinematics(std::move(robot), tolerance);
}

}  // namespace b4p
