// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include <Eigen/Core>

#include "planners/reach/reach_robot.h"
#include "planners/reach/reach_targets.h"

namespace b4p {

/// dq = J+ * twist by a damped pseudo-inverse; a joint that would leave [lower, upper] stops there and the
/// others make up for it as they can. No joint moves farther than 0.3 (rad or m): the whole step is
/// shortened.
Eigen::VectorXd jacobianStep(const TcpJacobian& jacobian, const TcpTwist& twist, const Eigen::VectorXd& q,
                             const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);

/// How a TCP is led towards a grasp.
struct DescentRules {
  /// Longest step of the TCP (m); turns are limited to as much by kMetresPerRadian.
  double cartesian_step_m = 0.05;
  /// Farther from the grasp than this (m) only its position counts.
  double orientation_distance_m = 0.15;
};

/// One way of the TCP towards one grasp, step by step, each step `J+ times a limited twist`.
class JacobianDescent {
 public:
  /// The limits have to outlive this object.
  JacobianDescent(const DescentRules& rules, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper)
      : rules_(rules), lower_(lower), upper_(upper) {}

  /// The step from q, where the TCP is `whole_way` from the grasp. Empty when the way has stalled: a joint
  /// limit or a singularity, no gain in 4 steps.
  Eigen::VectorXd step(ReachContext& context, const Eigen::VectorXd& q, const TcpTwist& whole_way);

 private:
  bool stalled(double distance);

  DescentRules rules_;
  const Eigen::VectorXd& lower_;
  const Eigen::VectorXd& upper_;
  bool close_ = false;
  double best_ = std::numeric_limits<double>::infinity();
  int steps_without_gain_ = 0;
};

/// Inverse kinematics for robots that have no better: from q (inside the limits) down to within the tolerance
/// of a grasp. False when it stalls or takes more than 100 steps; q is then anywhere inside the limits.
bool descendTo(GraspId grasp, const ReachTargets& targets, ReachContext& context,
               const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, Eigen::VectorXd& q);

}  // namespace b4p
