// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <Eigen/Geometry>

#include "planners/reach/reach_goal.h"

namespace b4p::test {

/// An arm of three links of 1 m in the plane z = 0, its base at the origin, among discs. The TCP's z axis
/// points along the last link, its x axis up. Everything is analytic.
struct PlanarArm : ReachRobot {
  struct Disc {
    Eigen::Vector2d centre;
    double radius;
  };
  using Points = std::array<Eigen::Vector2d, 4>;

  static constexpr unsigned kJoints = 3;
  static constexpr double kLimit_rad = 2.9;

  std::vector<Disc> discs;
  bool can_solve = true;  ///< false: inverse kinematics never finds anything
  std::function<void()> before_kinematics = [] {};
  std::function<void(const ReachTarget&)> before_inverse = [](const ReachTarget&) {};
  mutable std::atomic<std::uint64_t> inverse_calls{0};

  unsigned dof() const override { return kJoints; }
  std::unique_ptr<ReachContext> makeContext() const override;

  /// Base, joints and TCP.
  static Points points(const double* q) {
    Points points{Eigen::Vector2d::Zero()};
    double angle = 0.0;
    for (std::size_t i = 0; i < kJoints; ++i) {
      angle += q[i];
      points[i + 1] = points[i] + Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
    return points;
  }

  static Eigen::Isometry3d pose(const Eigen::Vector2d& position, double angle) {
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    const Eigen::Vector3d x = Eigen::Vector3d::UnitZ(), z(std::cos(angle), std::sin(angle), 0.0);
    X.linear() << x, z.cross(x), z;
    X.translation() << position, 0.0;
    return X;
  }

  static Eigen::Isometry3d tcpPose(const double* q) { return pose(points(q)[3], q[0] + q[1] + q[2]); }

  bool isFree(const double* q) const {
    const Points p = points(q);
    for (const Disc& disc : discs) {
      for (std::size_t i = 0; i < kJoints; ++i) {
        const Eigen::Vector2d link = p[i + 1] - p[i];
        const double along = std::clamp((disc.centre - p[i]).dot(link), 0.0, 1.0);
        if ((p[i] + along * link - disc.centre).norm() <= disc.radius) return false;
      }
    }
    return true;
  }
};

class PlanarArmContext : public ReachContext {
 public:
  explicit PlanarArmContext(const PlanarArm& arm) : arm_(arm) {}

  Eigen::Isometry3d tcpPose(const double* q) override {
    arm_.before_kinematics();
    return PlanarArm::tcpPose(q);
  }

  TcpJacobian jacobian(const double* q) override {
    const PlanarArm::Points p = PlanarArm::points(q);
    TcpJacobian jacobian = TcpJacobian::Zero(6, PlanarArm::kJoints);
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Eigen::Vector2d arm = p[3] - p[static_cast<std::size_t>(i)];
      jacobian.col(i) << -arm.y(), arm.x(), 0.0, 0.0, 0.0, 1.0;
    }
    return jacobian;
  }

  /// Elbow up or down, and where the orientation is free any that can be reached, by chance.
  bool inverse(const ReachTarget& target, std::mt19937_64& random, double* q) override {
    ++arm_.inverse_calls;
    arm_.before_inverse(target);
    if (!arm_.can_solve) return false;
    const Eigen::Vector3d z = target.X_WT.linear().col(2);
    if (!target.position_only && !target.X_WT.linear().col(0).isApprox(Eigen::Vector3d::UnitZ(), 1e-9))
      return false;
    const double angle = target.position_only ? std::uniform_real_distribution<double>(-3.14, 3.14)(random)
                                              : std::atan2(z.y(), z.x());
    const Eigen::Vector2d wrist =
        target.X_WT.translation().head<2>() - Eigen::Vector2d(std::cos(angle), std::sin(angle));
    const double bend = std::acos(0.5 * wrist.squaredNorm() - 1.0);  // NaN when out of reach
    q[1] = std::bernoulli_distribution()(random) ? bend : -bend;
    q[0] = std::atan2(wrist.y(), wrist.x()) - 0.5 * q[1];
    q[2] = std::remainder(angle - q[0] - q[1], 2.0 * std::acos(-1.0));
    q[0] = std::remainder(q[0], 2.0 * std::acos(-1.0));
    return std::all_of(q, q + 3, [](double v) { return std::abs(v) <= PlanarArm::kLimit_rad; });
  }

 private:
  const PlanarArm& arm_;
};

inline std::unique_ptr<ReachContext> PlanarArm::makeContext() const {
  return std::make_unique<PlanarArmContext>(*this);
}

/// Everything a planner needs to reach with a PlanarArm.
struct ArmProblem {
  explicit ArmProblem(ReachTargets targets, std::vector<PlanarArm::Disc> discs = {}) {
    arm->discs = std::move(discs);
    space = std::make_shared<ompl::base::RealVectorStateSpace>(PlanarArm::kJoints);
    space->setBounds(-PlanarArm::kLimit_rad, PlanarArm::kLimit_rad);
    si = std::make_shared<ompl::base::SpaceInformation>(space);
    si->setStateValidityChecker([this](const ompl::base::State* state) { return is_valid(values(state)); });
    si->setStateValidityCheckingResolution(0.002);
    si->setup();
    goal = std::make_shared<ReachGoal>(si, arm, std::move(targets));
    problem = std::make_shared<ompl::base::ProblemDefinition>(si);
    problem->addStartState(at(0.0, 0.0, 0.0));
    problem->setGoal(goal);
  }
  ArmProblem(const ArmProblem&) = delete;
  ArmProblem& operator=(const ArmProblem&) = delete;

  static const double* values(const ompl::base::State* state) {
    return state->as<ompl::base::RealVectorStateSpace::StateType>()->values;
  }

  ompl::base::ScopedState<> at(double q0, double q1, double q2) const {
    ompl::base::ScopedState<> state(si);
    state[0] = q0;
    state[1] = q1;
    state[2] = q2;
    return state;
  }

  std::shared_ptr<PlanarArm> arm = std::make_shared<PlanarArm>();
  /// Rejects what lies outside the limits, as every checker of this package does.
  std::function<bool(const double*)> is_valid = [this](const double* q) {
    return goal->joints().contains(q) && arm->isFree(q);
  };
  std::shared_ptr<ompl::base::RealVectorStateSpace> space;
  ompl::base::SpaceInformationPtr si;
  std::shared_ptr<ReachGoal> goal;
  ompl::base::ProblemDefinitionPtr problem;
};

/// Poses of the arm's TCP that it can take on, at `angles_rad`.
inline std::vector<Eigen::Isometry3d> posesAt(const Eigen::Vector2d& position,
                                              const std::vector<double>& angles_rad) {
  std::vector<Eigen::Isometry3d> poses;
  for (const double angle : angles_rad) poses.push_back(PlanarArm::pose(position, angle));
  return poses;
}

/// A disc on the straight way from the outstretched arm to the left half of the plane.
inline std::vector<PlanarArm::Disc> twoDiscs() { return {{{1.5, 1.5}, 0.5}, {{-0.2, 2.3}, 0.3}}; }

}  // namespace b4p::test
