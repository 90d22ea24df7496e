// SPDX-License-Identifier: BSD-3-Clause
#include "planners/placement/local_optimiser.h"

#include <cmath>

#include <Eigen/Eigenvalues>

#include "planners/manipulation_state_space.h"

namespace b4p {

namespace ob = ompl::base;

namespace {

using StateType = ManipulationStateSpace::StateType;
using Jacobian = PlacementContext::Jacobian;
using Twist = Eigen::Matrix<double, 6, 1>;

/// J+ twist = J^T (J J^T)^-1 twist, or nothing where J has a rank below 6.
Eigen::VectorXd solve(const Jacobian& J, const Twist& twist) {
  constexpr double kSmallestShare = 1e-3;  // of the largest singular value
  using Matrix6d = Eigen::Matrix<double, 6, 6>;
  const Eigen::SelfAdjointEigenSolver<Matrix6d> squares(Matrix6d(J * J.transpose()));
  const Twist& values = squares.eigenvalues();
  if (!(values[0] > kSmallestShare * kSmallestShare * values[5])) return {};
  const Matrix6d& axes = squares.eigenvectors();
  return J.transpose() * (axes * (axes.transpose() * twist).cwiseQuotient(values));
}

/// The velocity of point p_WT of a body whose point p_WO has `linear` and which turns with `angular`.
Twist twistAt(const Eigen::Vector3d& p_WT, const Eigen::Vector3d& p_WO, const Eigen::Vector3d& linear,
              const Eigen::Vector3d& angular) {
  Twist twist;
  twist << linear + angular.cross(p_WT - p_WO), angular;
  return twist;
}

}  // namespace

std::string LocalOptimisation::problem() const {
  if (!(step > 0.0) || !std::isfinite(step))
    return "local_step must be finite and > 0 (" + std::to_string(step) + ")";
  if (!(flat_gradient >= 0.0)) return "flat_gradient must be >= 0 (" + std::to_string(flat_gradient) + ")";
  return "";
}

LocalOptimiser::LocalOptimiser(const ob::SpaceInformationPtr& si, const PlacementGoal& goal,
                               const LocalOptimisation& settings)
    : si_(si), goal_(goal), settings_(settings), context_(goal.world().makeContext()) {}

// Empty where the Jacobian is singular.
Eigen::VectorXd LocalOptimiser::ascent(GraspId arm, const Eigen::VectorXd& q, const Eigen::Isometry3d& X_WO,
                                       const Eigen::Vector3d& gradient) {
  const Twist twist = twistAt(context_->tcpPose(arm, q.data()).translation(), X_WO.translation(),
                              {gradient.x(), gradient.y(), 0.0}, {0.0, 0.0, gradient.z()});
  Eigen::VectorXd dq = solve(context_->jacobian(arm, q.data()), twist);
  const double length = dq.norm();
  if (length > 0.0) dq *= settings_.step / length;
  return dq;
}

void LocalOptimiser::keepUpright(GraspId arm, const Eigen::Isometry3d& X_WO, Eigen::VectorXd& q) {
  constexpr int kPasses = 2;  // each squares the error
  const Eigen::Vector3d up_O = X_WO.linear().transpose() * Eigen::Vector3d::UnitZ();
  for (int pass = 0; pass < kPasses; ++pass) {
    const Eigen::Isometry3d X_WO_now = context_->objectPose(arm, q.data());
    const Eigen::Vector3d rise(0.0, 0.0, X_WO.translation().z() - X_WO_now.translation().z());
    const Eigen::Vector3d tilt = (X_WO_now.linear() * up_O).cross(Eigen::Vector3d::UnitZ());
    const Twist twist =
        twistAt(context_->tcpPose(arm, q.data()).translation(), X_WO_now.translation(), rise, tilt);
    const Eigen::VectorXd dq = solve(context_->jacobian(arm, q.data()), twist);
    if (dq.size() == 0) return;
    q += dq;
  }
}

LocalOptimiser::Result LocalOptimiser::improve(const ob::State* from, double objective,
                                               const ob::PlannerTerminationCondition& ptc) {
  Result result{{}, objective, LocalEnd::kSteps};
  std::vector<ob::ScopedState<>> level;  // states that gain nothing, so far
  double value = objective;
  ob::ScopedState<> here(si_->getStateSpace(), from);
  for (unsigned i = 0; i < settings_.steps; ++i) {
    ob::ScopedState<> next(here);
    const LocalEnd end = ptc ? LocalEnd::kTold : step(here.get(), value, next.get());
    if (end != LocalEnd::kSteps) {
      result.end = end;
      return result;
    }
    here = next;
    level.push_back(next);
    if (value <= result.objective) continue;
    result.objective = value;
    result.states.insert(result.states.end(), level.begin(), level.end());
    level.clear();
  }
  return result;
}

// kSteps: a step has been made, and `value` is the objective where it ends.
LocalEnd LocalOptimiser::step(const ob::State* here, double& value, ob::State* next) {
  const auto* s = here->as<StateType>();
  const ob::RealVectorBounds& bounds = si_->getStateSpace()->as<ManipulationStateSpace>()->bounds();
  const auto dof = static_cast<Eigen::Index>(bounds.low.size());
  const Eigen::Map<const Eigen::VectorXd> q(s->q, dof), lower(bounds.low.data(), dof),
      upper(bounds.high.data(), dof);
  const auto beyondLimits = [&](const Eigen::VectorXd& to) {
    return !((to.array() >= lower.array()).all() && (to.array() <= upper.array()).all());
  };
  const Eigen::Isometry3d X_WO = context_->objectPose(s->grasp, s->q);
  const Eigen::Vector3d gradient = goal_.objective().planarGradient(X_WO);
  if (gradient.norm() < settings_.flat_gradient) return LocalEnd::kFlat;
  const Eigen::VectorXd dq = ascent(s->grasp, q, X_WO, gradient);
  if (dq.size() == 0) return LocalEnd::kSingular;
  Eigen::VectorXd q_next = q + dq;
  if (beyondLimits(q_next)) return LocalEnd::kJointLimit;
  keepUpright(s->grasp, X_WO, q_next);
  if (beyondLimits(q_next)) return LocalEnd::kJointLimit;
  Eigen::VectorXd::Map(next->as<StateType>()->q, dof) = q_next;
  const Eigen::Isometry3d X_WO_next = context_->objectPose(s->grasp, q_next.data());
  const double next_value = goal_.objective().value(X_WO_next);
  if (!(next_value >= value)) return LocalEnd::kNoGain;
  if (!goal_.world().stable(X_WO_next)) return LocalEnd::kLostContact;
  if (!context_->objectFree(X_WO_next) || !si_->checkMotion(here, next)) return LocalEnd::kCollision;
  value = next_value;
  return LocalEnd::kSteps;
}

}  // namespace b4p
