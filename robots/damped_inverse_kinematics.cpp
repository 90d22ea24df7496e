// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "robots/aligned_chain.h"
#include "robots/inverse_kinematics.h"

namespace b4p {
namespace {

constexpr int kMaxIterations = 50;
/// One radian counts as much as this many metres in the error that is minimised.
constexpr double kRotationWeight_m = 0.3;
/// Damping: this share of the squared error, and a little more that keeps singular postures solvable.
constexpr double kDampingShare = 0.1;
constexpr double kLeastDamping = 1e-8;
/// An attempt is given up when this many iterations did not reduce the squared error to this share of it.
constexpr int kPatience = 4;
constexpr double kProgress = 0.5;
/// The solver stops at this share of the tolerance, so that its answers pass the check that follows.
constexpr double kShareOfTolerance = 0.5;

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// The rotation that leads from `reached` to `target`, as axis times angle (rad) in world axes.
Eigen::Vector3d rotationBetween(const Eigen::Matrix3d& reached, const Eigen::Matrix3d& target) {
  const Eigen::Matrix3d R = target * reached.transpose();
  const Eigen::Vector3d twice_sine(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
  const double sine = 0.5 * twice_sine.norm(), cosine = 0.5 * (R.trace() - 1.0);
  if (sine > 1e-9) return twice_sine * (0.5 * std::atan2(sine, cosine) / sine);
  if (cosine > 0.0) return 0.5 * twice_sine;
  const Eigen::AngleAxisd half_turn(R);
  return half_turn.angle() * half_turn.axis();
}

/// Damped least squares with the damping in proportion to the squared error (Sugihara,
/// "Solvability-unconcerned inverse kinematics by the Levenberg-Marquardt method", T-RO 2011). Joints stay
/// inside their limits throughout; one that rests on a limit and is pushed outwards is left out of the step.
/// `kDof` is the number of joints or Eigen::Dynamic; nothing is allocated while it iterates.
template <int kDof>
class DampedInverseKinematics : public InverseKinematics {
 public:
  DampedInverseKinematics(std::shared_ptr<const Manipulator> robot_in, IkTolerance tolerance)
      : InverseKinematics(std::move(robot_in), tolerance), chain_(robot()) {
    jacobian_.resize(6, robot().dof());
    step_.resize(robot().dof());
  }

 protected:
  bool attempt(const Eigen::Isometry3d& X_WT, const Eigen::VectorXd& seed, Eigen::VectorXd& q) override {
    for (int i = 0; i < q.size(); ++i) q[i] = limits().bringInside(i, seed[i]);
    double milestone = std::numeric_limits<double>::infinity();
    int since_milestone = 0;
    for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
      const Eigen::Isometry3d reached = chain_.tcpPose(q.data(), jacobian_);
      Vector6d error;
      error << X_WT.translation() - reached.translation(), rotationBetween(reached.linear(), X_WT.linear());
      if (error.head<3>().norm() <= kShareOfTolerance * tolerance().position_m &&
          error.tail<3>().norm() <= kShareOfTolerance * tolerance().angle_rad)
        return true;
      error.tail<3>() *= kRotationWeight_m;
      const double squared_error = error.squaredNorm();
      if (squared_error < kProgress * milestone) {
        milestone = squared_error;
        since_milestone = 0;
      } else if (++since_milestone > kPatience || !(squared_error < std::numeric_limits<double>::max())) {
        return false;
      }
      takeStep(error, squared_error, q);
    }
    return false;
  }

 private:
  void takeStep(const Vector6d& error, double squared_error, Eigen::VectorXd& q) {
    jacobian_.template bottomRows<3>() *= kRotationWeight_m;
    for (int i = 0; i < q.size(); ++i)
      if (limits().blocks(i, q[i], jacobian_.col(i).dot(error))) jacobian_.col(i).setZero();
    Matrix6d A = jacobian_.lazyProduct(jacobian_.transpose());
    A.diagonal().array() += kDampingShare * squared_error + kLeastDamping;
    step_.noalias() = jacobian_.transpose() * A.llt().solve(error);
    for (int i = 0; i < q.size(); ++i) q[i] = limits().bringInside(i, q[i] + step_[i]);
  }

  AlignedChain chain_;
  Eigen::Matrix<double, 6, kDof> jacobian_;
  Eigen::Matrix<double, kDof, 1> step_;
};

}  // namespace

std::unique_ptr<InverseKinematics> makeDampedInverseKinematics(std::shared_ptr<const Manipulator> robot,
                                                               IkTolerance tolerance) {
  if (robot->dof() == 6) return std::make_unique<DampedInverseKinematics<6>>(std::move(robot), tolerance);
  if (robot->dof() == 7) return std::make_unique<DampedInverseKinematics<7>>(std::move(robot), tolerance);
  return std::make_unique<DampedInverseKinematics<Eigen::Dynamic>>(std::move(robot), tolerance);
}

}  // namespace b4p
