// SPDX-License-Identifier: BSD-3-Clause
#include "planners/reach/reach_targets.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace b4p {
namespace {

constexpr double kRotationError = 1e-4;

std::invalid_argument badRow(std::size_t index, const std::string& problem) {
  return std::invalid_argument("row " + std::to_string(index + 1) + ": " + problem);
}

bool isRotation(const Eigen::Matrix3d& R) {
  return (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <= kRotationError &&
         R.determinant() > 0.0;
}

bool positive(double value) { return std::isfinite(value) && value > 0.0; }

/// A turn by 180 degrees about the approach axis.
const Eigen::DiagonalMatrix<double, 3> kFlip(-1.0, -1.0, 1.0);

/// Trace of R_AB for two orientations A and B, and of the one with B flipped.
struct Traces {
  Traces(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
    const Eigen::RowVector3d dots = a.cwiseProduct(b).colwise().sum();
    straight = dots[2] + dots[0] + dots[1];
    flipped = dots[2] - dots[0] - dots[1];
  }
  double straight, flipped;
};

double angleOfTrace(double trace) {
  return 2.0 * std::asin(std::min(1.0, 0.5 * std::sqrt(std::max(0.0, 3.0 - trace))));
}

}  // namespace

ReachTargets::ReachTargets(std::vector<Eigen::Isometry3d> X_WT, bool position_only,
                           const ReachTolerance& tolerance)
    : X_WT_(std::move(X_WT)), position_only_(position_only), tolerance_(tolerance) {
  if (X_WT_.empty()) throw std::invalid_argument("there are no grasps");
  if (!positive(tolerance.position_m) || !positive(tolerance.angle_rad))
    throw std::invalid_argument("tolerances have to be positive and finite");
}

ReachTargets ReachTargets::poses(const std::vector<Eigen::Isometry3d>& X_WT,
                                 const ReachTolerance& tolerance) {
  std::vector<Eigen::Isometry3d> poses = X_WT;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!poses[i].matrix().allFinite()) throw badRow(i, "the pose is not finite");
    if (poses[i].matrix().row(3) != Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0))
      throw badRow(i, "the last row of the pose is not 0 0 0 1");
    if (!isRotation(poses[i].linear())) throw badRow(i, "the rotation of the pose is not orthonormal");
    poses[i].linear() = Eigen::Quaterniond(poses[i].linear()).normalized().toRotationMatrix();
  }
  return ReachTargets(std::move(poses), false, tolerance);
}

ReachTargets ReachTargets::positions(const std::vector<Eigen::Vector3d>& p_WT, double tolerance_m) {
  std::vector<Eigen::Isometry3d> poses(p_WT.size(), Eigen::Isometry3d::Identity());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!p_WT[i].allFinite()) throw badRow(i, "the position is not finite");
    poses[i].translation() = p_WT[i];
  }
  ReachTolerance tolerance;
  tolerance.position_m = tolerance_m;
  return ReachTargets(std::move(poses), true, tolerance);
}

ReachTarget ReachTargets::target(GraspId grasp, bool flipped) const {
  ReachTarget target{X_WT_[static_cast<std::size_t>(grasp)], position_only_};
  if (flipped) target.X_WT.linear() = target.X_WT.linear() * kFlip;
  return target;
}

TcpTwist ReachTargets::twistTo(GraspId grasp, const Eigen::Isometry3d& X_WT) const {
  const Eigen::Isometry3d& goal = X_WT_[static_cast<std::size_t>(grasp)];
  TcpTwist twist;
  twist.linear = goal.translation() - X_WT.translation();
  if (position_only_) return twist;
  const Traces traces(goal.linear(), X_WT.linear());
  const bool flipped = tolerance_.flip && traces.flipped > traces.straight;
  const Eigen::Matrix3d R = target(grasp, flipped).X_WT.linear();
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(R * X_WT.linear().transpose()));
  twist.angular = turn.angle() * turn.axis();
  return twist;
}

double ReachTargets::distance(GraspId grasp, const Eigen::Isometry3d& X_WT) const {
  const Eigen::Isometry3d& goal = X_WT_[static_cast<std::size_t>(grasp)];
  const double distance_m = (goal.translation() - X_WT.translation()).norm();
  const double beyond_m = std::max(0.0, distance_m - tolerance_.position_m);
  if (position_only_) return beyond_m;
  const Traces traces(goal.linear(), X_WT.linear());
  const double trace = tolerance_.flip ? std::max(traces.straight, traces.flipped) : traces.straight;
  return beyond_m + kMetresPerRadian * std::max(0.0, angleOfTrace(trace) - tolerance_.angle_rad);
}

}  // namespace b4p
