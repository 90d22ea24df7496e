// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/retreat.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace b4p {
namespace {

constexpr double kStep_m = 0.04;
constexpr IkTolerance kTolerance{1e-4, 1e-3};
/// A joint that turns farther than this has gone to another posture (rad or m).
constexpr double kNear = 0.5;
constexpr int kHandDirections = 6;

/// Neighbour 0 ... 25 of a cube among its 27.
Eigen::Vector3d worldDirection(int neighbour) {
  constexpr int kCentre = 13;
  const int code = neighbour < kCentre ? neighbour : neighbour + 1;
  return Eigen::Vector3d(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1).normalized();
}

Eigen::Vector3d directionInWorld(int direction, const Eigen::Matrix3d& R_WT) {
  if (direction >= kHandDirections) return worldDirection(direction - kHandDirections);
  return (direction % 2 == 0 ? -1.0 : 1.0) * R_WT.col(direction / 2);
}

}  // namespace

Retreat::Retreat(std::shared_ptr<const Manipulator> robot, FloatingBody& hand)
    : robot_(robot), hand_(hand), kinematics_(makeDampedInverseKinematics(std::move(robot), kTolerance)) {}

void Retreat::handReach(const Eigen::Isometry3d& X_WT, const Grasp& grasp, int steps, int* reach) {
  going_.resize(kDirections);
  std::iota(going_.begin(), going_.end(), 0);
  std::fill_n(reach, kDirections, steps);
  for (int step = 1; step <= steps && !going_.empty(); ++step) {
    shifts_m_.clear();
    for (const int direction : going_)
      shifts_m_.push_back(step * kStep_m * directionInWorld(direction, X_WT.linear()));
    hand_.areFreeShifted(X_WT, shifts_m_, grasp, free_);
    std::size_t left = 0;
    for (std::size_t i = 0; i < going_.size(); ++i) {
      if (free_[i])
        going_[left++] = going_[i];
      else
        reach[going_[i]] = step - 1;
    }
    going_.resize(left);
  }
}

bool Retreat::step(const double* q, int direction, double* next) {
  seed_ = Eigen::Map<const Eigen::VectorXd>(q, robot_->dof());
  Eigen::Isometry3d X_WT = robot_->tcpPose(q);
  X_WT.pretranslate(kStep_m * directionInWorld(direction, X_WT.linear()));
  if (!kinematics_->solveFrom(X_WT, seed_, answer_)) return false;
  if ((answer_ - seed_).lpNorm<Eigen::Infinity>() > kNear) return false;
  std::copy_n(answer_.data(), answer_.size(), next);
  return true;
}

}  // namespace b4p
