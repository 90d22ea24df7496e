// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/reach/reach_robot.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "experiments/floating_body.h"
#include "planners/reach/jacobian_descent.h"
#include "robots/kinematic_chain.h"

namespace b4p {
namespace {

class ManipulatorReachContext : public ReachContext {
 public:
  ManipulatorReachContext(const std::shared_ptr<const Manipulator>& robot,
                          std::unique_ptr<InverseKinematics> ik, const CollisionChecker* hand)
      : robot_(robot), chain_(robot), ik_(std::move(ik)) {
    if (hand != nullptr) hand_.emplace(*hand);
    open_.opening_m = robot->description().max_opening_m;
  }

  Eigen::Isometry3d tcpPose(const double* q) override { return chain_.tcpPose(q); }
  TcpJacobian jacobian(const double* q) override { return chain_.jacobian(q); }

  bool inverse(const ReachTarget& target, std::mt19937_64& random, double* q) override {
    constexpr double kPositionTolerance_m = 1e-4;
    bool found = false;
    if (target.position_only) {
      const ReachTargets targets = ReachTargets::positions({target.X_WT.translation()}, kPositionTolerance_m);
      answer_ = randomConfiguration(random);
      found = descendTo(0, targets, *this, robot_->lower(), robot_->upper(), answer_);
    } else {
      found = (!hand_ || hand_->isFree(target.X_WT, open_)) && ik_->solve(target.X_WT, random, 1, answer_);
    }
    if (found) std::copy_n(answer_.data(), answer_.size(), q);
    return found;
  }

 private:
  Eigen::VectorXd randomConfiguration(std::mt19937_64& random) const {
    Eigen::VectorXd q(robot_->dof());
    for (Eigen::Index i = 0; i < q.size(); ++i)
      q[i] = std::uniform_real_distribution<double>(robot_->lower()[i], robot_->upper()[i])(random);
    return q;
  }

  std::shared_ptr<const Manipulator> robot_;
  KinematicChain chain_;
  std::unique_ptr<InverseKinematics> ik_;
  Eigen::VectorXd answer_;
  std::optional<FloatingBody> hand_;
  Grasp open_;
};

}  // namespace

ManipulatorReachRobot::ManipulatorReachRobot(std::shared_ptr<const Manipulator> robot)
    : ManipulatorReachRobot(std::move(robot), [](const std::shared_ptr<const Manipulator>& manipulator) {
        return makeInverseKinematics(manipulator);
      }) {}

ManipulatorReachRobot::ManipulatorReachRobot(std::shared_ptr<const Manipulator> robot, IkFactory make_ik)
    : robot_(std::move(robot)), make_ik_(std::move(make_ik)) {}

ManipulatorReachRobot::ManipulatorReachRobot(std::shared_ptr<const Manipulator> robot,
                                             std::shared_ptr<const CollisionChecker> hand)
    : ManipulatorReachRobot(std::move(robot)) {
  hand_ = std::move(hand);
}

unsigned ManipulatorReachRobot::dof() const { return static_cast<unsigned>(robot_->dof()); }

std::unique_ptr<ReachContext> ManipulatorReachRobot::makeContext() const {
  return std::make_unique<ManipulatorReachContext>(robot_, make_ik_(robot_), hand_.get());
}

}  // namespace b4p
