// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/ScopedState.h>
#include <Eigen/Geometry>

#include "planners/grasp_motion_checker.h"
#include "planners/manipulation_state_space.h"
#include "planners/manipulation_validity.h"
#include "planners/placement/placement_goal.h"

namespace b4p::test {

/// How an arm holds the object, and how far it reaches.
struct LeverArm {
  Eigen::Vector3d p_TO{0.1, 0.0, -0.2};  ///< middle of the object's foot, seen from the TCP
  double farthest_x_m = 10.0;            ///< of the TCP
};

/// A cylinder is put on a table among walls by lever arms: two links of 1.4 m in the plane y = 0 that pitch
/// at shoulder (q0) and elbow (q2), slide along y as a whole (q1), and keep the wrist (yaw q3, pitch q4, roll
/// q5) level. Everything is analytic. World frame on the middle of the table top, 2 m x 2 m.
struct LeverWorld : PlacementWorld {
  /// Stands on the table.
  struct Block {
    Eigen::Vector2d min, max;
    double height_m;
  };
  static constexpr double kLink_m = 1.4, kBase_m = -1.6, kTable_m = 1.0, kRadius_m = 0.1;
  static constexpr double kTouch_m = 1e-3, kLevel_rad = 0.01;

  std::vector<Block> blocks;
  std::vector<LeverArm> arms{LeverArm{}, LeverArm{{0.0, 0.1, -0.2}, 10.0}};
  std::vector<ContactRegion> table = tableTop();
  bool stiff = false;  ///< true: the wrist cannot roll, as far as the Jacobian says
  std::function<void()> before_kinematics = [] {};

  static std::vector<ContactRegion> tableTop() {
    ContactRegion region{0.0, 0.05, {}};
    for (int i = 0; i < 40; ++i)
      for (int j = 0; j < 40; ++j)
        region.cells.emplace_back(-kTable_m + 0.05 * (i + 0.5), -kTable_m + 0.05 * (j + 0.5));
    return {region};
  }

  static Eigen::Isometry3d tcp(const double* q) {
    Eigen::Isometry3d X_WT = Eigen::Isometry3d::Identity();
    X_WT.translation() << kBase_m + kLink_m * (std::cos(q[0]) + std::cos(q[0] + q[2])), q[1],
        kLink_m * (std::sin(q[0]) + std::sin(q[0] + q[2]));
    X_WT.linear() = (Eigen::AngleAxisd(q[3], Eigen::Vector3d::UnitZ()) *
                     Eigen::AngleAxisd(q[4], Eigen::Vector3d::UnitY()) *
                     Eigen::AngleAxisd(q[5], Eigen::Vector3d::UnitX()))
                        .toRotationMatrix();
    return X_WT;
  }

  const LeverArm& arm(GraspId number) const { return arms.at(static_cast<std::size_t>(number)); }

  Eigen::Isometry3d objectAt(GraspId number, const double* q) const {
    return tcp(q) * Eigen::Translation3d(arm(number).p_TO);
  }

  static double tilt(const Eigen::Isometry3d& X_WO) {
    return X_WO.linear().col(2).cross(Eigen::Vector3d::UnitZ()).norm();
  }

  bool isFree(const Eigen::Isometry3d& X_WO) const {
    const Eigen::Vector3d p = X_WO.translation();
    if (p.z() - kRadius_m * tilt(X_WO) < -kTouch_m) return false;
    const double reach = kRadius_m + 0.3 * tilt(X_WO);
    return std::none_of(blocks.begin(), blocks.end(), [&](const Block& block) {
      const Eigen::Vector2d near = p.head<2>().cwiseMax(block.min).cwiseMin(block.max);
      return p.z() <= block.height_m && (p.head<2>() - near).norm() <= reach;
    });
  }

  bool isArmFree(GraspId number, const double* q) const {
    const Eigen::Vector3d p = tcp(q).translation();
    return p.z() >= 0.0 && p.x() <= arm(number).farthest_x_m && isFree(objectAt(number, q));
  }

  unsigned dof() const override { return 6; }
  GraspId armCount() const override { return static_cast<GraspId>(arms.size()); }
  int faceCount() const override { return 1; }
  const std::vector<ContactRegion>& regions() const override { return table; }

  Eigen::Isometry3d objectPose(const Placement& placement) const override {
    return Eigen::Translation3d(placement.p_WV.x(), placement.p_WV.y(), 0.0) *
           Eigen::AngleAxisd(placement.angle_rad, Eigen::Vector3d::UnitZ());
  }

  bool locate(const Eigen::Isometry3d& X_WO, Placement& placement) const override {
    if (!stable(X_WO)) return false;
    const double angle = std::atan2(X_WO.linear()(1, 0), X_WO.linear()(0, 0));
    placement = {kNoGrasp, 0, 0, X_WO.translation().head<2>(),
                 angle < 0.0 ? angle + 2.0 * std::acos(-1.0) : angle};
    return true;
  }

  bool stable(const Eigen::Isometry3d& X_WO) const override {
    const Eigen::Vector3d p = X_WO.translation();
    return std::abs(p.z()) <= kTouch_m && tilt(X_WO) <= kLevel_rad &&
           p.head<2>().cwiseAbs().maxCoeff() <= kTable_m - kRadius_m;
  }

  std::unique_ptr<PlacementContext> makeContext() const override;
};

class LeverContext : public PlacementContext {
 public:
  explicit LeverContext(const LeverWorld& world) : world_(world) {}

  bool objectFree(const Eigen::Isometry3d& X_WO) override { return world_.isFree(X_WO); }
  bool handFree(GraspId, const Eigen::Isometry3d& X_WO) override { return world_.isFree(X_WO); }

  bool inverse(GraspId arm, const Eigen::Isometry3d& X_WO, std::mt19937_64&, double* q) override {
    constexpr double L = LeverWorld::kLink_m;
    const Eigen::Isometry3d X_WT = X_WO * Eigen::Translation3d(-world_.arm(arm).p_TO);
    const Eigen::Matrix3d& R = X_WT.linear();
    const double x = X_WT.translation().x() - LeverWorld::kBase_m, z = X_WT.translation().z();
    const double far = std::hypot(x, z);
    if (far >= 2.0 * L) return false;
    q[2] = -2.0 * std::acos(0.5 * far / L);
    q[0] = std::atan2(z, x) - 0.5 * q[2];
    q[1] = X_WT.translation().y();
    q[3] = std::atan2(R(1, 0), R(0, 0));
    q[4] = std::asin(std::clamp(-R(2, 0), -1.0, 1.0));
    q[5] = std::atan2(R(2, 1), R(2, 2));
    return true;
  }

  bool armFree(GraspId arm, const double* q) override { return world_.isArmFree(arm, q); }
  Eigen::Isometry3d tcpPose(GraspId, const double* q) override {
    world_.before_kinematics();
    return LeverWorld::tcp(q);
  }
  Eigen::Isometry3d objectPose(GraspId arm, const double* q) override { return world_.objectAt(arm, q); }

  Jacobian jacobian(GraspId, const double* q) override {
    const Eigen::Isometry3d X_WT = LeverWorld::tcp(q);
    const Eigen::Matrix3d yaw = Eigen::AngleAxisd(q[3], Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const double fore = q[0] + q[2];
    Jacobian J = Jacobian::Zero(6, 6);
    J.col(0).head<3>() << -X_WT.translation().z(), 0.0, X_WT.translation().x() - LeverWorld::kBase_m;
    J(1, 1) = 1.0;
    J.col(2).head<3>() << -LeverWorld::kLink_m * std::sin(fore), 0.0, LeverWorld::kLink_m * std::cos(fore);
    J.col(3).tail<3>() = Eigen::Vector3d::UnitZ();
    J.col(4).tail<3>() = yaw.col(1);
    if (!world_.stiff) J.col(5).tail<3>() = X_WT.linear().col(0);
    return J;
  }

 private:
  const LeverWorld& world_;
};

inline std::unique_ptr<PlacementContext> LeverWorld::makeContext() const {
  return std::make_unique<LeverContext>(*this);
}

/// Checks straight motions of the joints every 0.005 (rad, m).
class LeverMotions : public GraspMotionChecker {
 public:
  explicit LeverMotions(std::shared_ptr<const LeverWorld> world) : world_(std::move(world)) {}

  std::unique_ptr<GraspMotionContext> makeContext() const override {
    class Context : public GraspMotionContext {
     public:
      explicit Context(const LeverWorld& world) : world_(world) {}
      bool isFree(const double* q, GraspId arm) override { return world_.isArmFree(arm, q); }
      bool isEdgeFree(const double* q1, const double* q2, GraspId arm) override {
        return freeFraction(q1, q2, arm) >= 1.0;
      }
      double freeFraction(const double* q1, const double* q2, GraspId arm) override {
        using Joints = Eigen::Matrix<double, 6, 1>;
        const Joints a = Eigen::Map<const Joints>(q1), b = Eigen::Map<const Joints>(q2);
        const int pieces = std::max(1, static_cast<int>(std::ceil((b - a).norm() / 0.005)));
        for (int k = 0; k <= pieces; ++k) {
          const Joints q = k == pieces ? b : Joints(a + (b - a) * k / pieces);
          if (!isFree(q.data(), arm)) return static_cast<double>(k - 1) / pieces;
        }
        return 1.0;
      }

     private:
      const LeverWorld& world_;
    };
    return std::make_unique<Context>(*world_);
  }

 private:
  std::shared_ptr<const LeverWorld> world_;
};

/// Everything a planner needs for a LeverWorld. The arms start above the table's far left.
struct LeverProblem {
  using Value = std::function<double(const Eigen::Isometry3d&)>;

  LeverProblem(const LeverWorld& described, const Value& value, const PlacementOptions& options = {})
      : world(std::make_shared<LeverWorld>(described)) {
    ompl::base::RealVectorBounds bounds(6);
    const double low[] = {-2.5, -1.5, -2.9, -3.2, -0.5, -0.5}, high[] = {2.5, 1.5, -0.05, 3.2, 0.5, 0.5};
    for (unsigned i = 0; i < 6; ++i) {
      bounds.setLow(i, low[i]);
      bounds.setHigh(i, high[i]);
    }
    space = std::make_shared<ManipulationStateSpace>(bounds);
    space->setGraspCount([count = world->armCount()] { return count; });
    si = makeManipulationSpaceInformation(space, std::make_shared<LeverMotions>(world));
    objective = std::make_shared<CallableObjective>(value);
    goal = std::make_shared<PlacementGoal>(si, world, objective, options);
    problem = std::make_shared<ompl::base::ProblemDefinition>(si);
    problem->setGoal(goal);
    for (GraspId arm = 0; arm < world->armCount(); ++arm)
      problem->addStartState(holding(arm, {-0.8, 0.8, 0.6}));
  }

  /// The arm that holds the object there, upright, turned by yaw_rad.
  ompl::base::ScopedState<> holding(GraspId arm, const Eigen::Vector3d& p_WO, double yaw_rad = 0.0) const {
    ompl::base::ScopedState<> state(si);
    auto* s = state->as<ManipulationStateSpace::StateType>();
    std::mt19937_64 random;
    const Eigen::Isometry3d X_WO =
        Eigen::Translation3d(p_WO) * Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ());
    if (!LeverContext(*world).inverse(arm, X_WO, random, s->q)) throw std::invalid_argument("out of reach");
    s->grasp = arm;
    return state;
  }

  Eigen::Isometry3d objectAt(const ompl::base::State* state) const {
    const auto* s = state->as<ManipulationStateSpace::StateType>();
    return world->objectAt(s->grasp, s->q);
  }

  std::shared_ptr<LeverWorld> world;
  std::shared_ptr<ManipulationStateSpace> space;
  ompl::base::SpaceInformationPtr si;
  std::shared_ptr<CallableObjective> objective;
  std::shared_ptr<PlacementGoal> goal;
  ompl::base::ProblemDefinitionPtr problem;
};

/// How near the object is to a point, the optimum being 0 and there: -d^2.
inline LeverProblem::Value nearTo(const Eigen::Vector2d& target) {
  return [target](const Eigen::Isometry3d& X_WO) {
    return -(X_WO.translation().head<2>() - target).squaredNorm();
  };
}

}  // namespace b4p::test
