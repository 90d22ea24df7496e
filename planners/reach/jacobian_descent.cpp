// SPDX-License-Identifier: BSD-3-Clause
#include "planners/reach/jacobian_descent.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace b4p {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

constexpr double kDamping = 0.03;          // against singular values (m per rad)
constexpr double kLongestJointStep = 0.3;  // rad or m
constexpr double kGain = 0.99;             // a step gains when it shortens the way to this share
constexpr int kPatience = 4;
constexpr double kShortestJointStep = 1e-6;  // rad or m

/// Rows weighted so that metres and radians compare.
void weigh(Vector6d& twist) { twist.tail<3>() *= kMetresPerRadian; }

TcpTwist limited(TcpTwist twist, double longest_m) {
  const double turn_m = kMetresPerRadian * twist.angular.norm();
  if (twist.linear.norm() > longest_m) twist.linear *= longest_m / twist.linear.norm();
  if (turn_m > longest_m) twist.angular *= longest_m / turn_m;
  return twist;
}

}  // namespace

Eigen::VectorXd jacobianStep(const TcpJacobian& jacobian, const TcpTwist& twist, const Eigen::VectorXd& q,
                             const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
  TcpJacobian J = jacobian;
  Vector6d wanted;
  wanted << twist.linear, twist.angular;
  weigh(wanted);
  J.bottomRows<3>() *= kMetresPerRadian;
  if (twist.angular.isZero(0.0)) J.bottomRows<3>().setZero();  // the orientation may do as it likes
  Eigen::VectorXd stopped = Eigen::VectorXd::Zero(q.size());
  Eigen::VectorXd dq = stopped;
  for (Eigen::Index pass = 0; pass <= q.size(); ++pass) {
    const Matrix6d normal = J * J.transpose() + kDamping * kDamping * Matrix6d::Identity();
    dq = stopped + J.transpose() * Eigen::LLT<Matrix6d>(normal).solve(wanted);
    bool more = false;
    for (Eigen::Index i = 0; i < q.size(); ++i) {
      const double to = q[i] + dq[i];
      if ((to >= lower[i] && to <= upper[i]) || J.col(i).isZero(0.0)) continue;
      const double within = std::clamp(to, lower[i], upper[i]) - q[i];
      stopped[i] = within;
      wanted -= J.col(i) * within;
      J.col(i).setZero();
      more = true;
    }
    if (!more) break;
  }
  const double longest = dq.cwiseAbs().maxCoeff();
  if (longest > kLongestJointStep) dq *= kLongestJointStep / longest;
  return dq;
}

bool JacobianDescent::stalled(double distance) {
  if (distance <= kGain * best_) {
    best_ = distance;
    steps_without_gain_ = 0;
    return false;
  }
  return ++steps_without_gain_ >= kPatience;
}

Eigen::VectorXd JacobianDescent::step(ReachContext& context, const Eigen::VectorXd& q,
                                      const TcpTwist& whole_way) {
  TcpTwist twist = whole_way;
  const double far_m = twist.linear.norm();
  if (far_m > rules_.orientation_distance_m && !close_) {
    twist.angular.setZero();
  } else if (!close_) {
    close_ = true;
    best_ = std::numeric_limits<double>::infinity();
    steps_without_gain_ = 0;
  }
  if (stalled(far_m + kMetresPerRadian * twist.angular.norm())) return {};
  const Eigen::VectorXd dq =
      jacobianStep(context.jacobian(q.data()), limited(twist, rules_.cartesian_step_m), q, lower_, upper_);
  const Eigen::VectorXd next = (q + dq).cwiseMax(lower_).cwiseMin(upper_);
  if ((next - q).cwiseAbs().maxCoeff() < kShortestJointStep) return {};
  return next;
}

bool descendTo(GraspId grasp, const ReachTargets& targets, ReachContext& context,
               const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, Eigen::VectorXd& q) {
  constexpr int kMostSteps = 100;
  constexpr double kAnywhere = std::numeric_limits<double>::infinity();
  JacobianDescent descent({0.2, kAnywhere}, lower, upper);
  for (int i = 0; i < kMostSteps; ++i) {
    const Eigen::Isometry3d X_WT = context.tcpPose(q.data());
    if (targets.within(grasp, X_WT)) return true;
    const Eigen::VectorXd next = descent.step(context, q, targets.twistTo(grasp, X_WT));
    if (next.size() == 0) return false;
    q = next;
  }
  return false;
}

}  // namespace b4p
