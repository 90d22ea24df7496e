// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/scene_placement_world.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "experiments/floating_body.h"
#include "experiments/placement/resting_arms.h"
#include "robots/input_error.h"
#include "robots/inverse_kinematics.h"
#include "robots/kinematic_chain.h"

namespace b4p {
namespace {

constexpr double kLevel_rad = 0.01;  ///< a face tilted by less is horizontal
constexpr IkTolerance kIkTolerance{1e-5, 1e-4};

/// The scene's obstacles and object around a robot, other arms left out.
CollisionProblem problemOf(const Scene& scene, const std::shared_ptr<const Manipulator>& robot) {
  CollisionProblem problem;
  problem.robot = robot;
  problem.obstacles = scene.obstacles;
  problem.object = scene.placing().object;
  problem.edge_step_m = scene.edge_step_m;
  return problem;
}

ScenePlacementWorld::Arm makeArm(const Scene& scene, std::size_t index) {
  ScenePlacementWorld::Arm arm;
  arm.robot = robotWithOthersAtRest(scene, index);
  arm.grasp = scene.placing().arms[index].grasp;
  CollisionProblem problem = problemOf(scene, arm.robot);
  for (Obstacle& link : otherRobots(scene, index)) problem.obstacles.push_back(std::move(link));
  try {
    arm.checker = makeFclChecker(problem);
    arm.hand = FloatingBody::makeChecker(problem, FloatingBody::Parts::kGripper);
  } catch (const std::invalid_argument& e) {
    throw InputError(scene.file, "", e.what());
  }
  return arm;
}

class Context : public PlacementContext {
 public:
  Context(const std::vector<ScenePlacementWorld::Arm>& arms, const CollisionChecker& object)
      : object_(object), object_grasp_(arms.front().grasp) {
    for (const auto& arm : arms) arms_.emplace_back(std::make_unique<ArmTools>(arm));
  }

  bool objectFree(const Eigen::Isometry3d& X_WO) override {
    return object_.isFree(X_WO * object_grasp_.X_OT, object_grasp_);
  }
  bool handFree(GraspId arm, const Eigen::Isometry3d& X_WO) override {
    ArmTools& a = tools(arm);
    return a.hand.isFree(X_WO * a.grasp.X_OT, a.grasp);
  }
  bool inverse(GraspId arm, const Eigen::Isometry3d& X_WO, std::mt19937_64& random, double* q) override {
    ArmTools& a = tools(arm);
    if (!a.ik->solve(X_WO * a.grasp.X_OT, random, 1, a.answer)) return false;
    std::copy_n(a.answer.data(), a.answer.size(), q);
    return true;
  }
  bool armFree(GraspId arm, const double* q) override {
    ArmTools& a = tools(arm);
    return a.collisions->isFree(q, &a.grasp);
  }
  Eigen::Isometry3d tcpPose(GraspId arm, const double* q) override { return tools(arm).chain.tcpPose(q); }
  Eigen::Isometry3d objectPose(GraspId arm, const double* q) override {
    ArmTools& a = tools(arm);
    return a.chain.tcpPose(q) * a.X_TO;
  }
  Jacobian jacobian(GraspId arm, const double* q) override { return tools(arm).chain.jacobian(q); }

 private:
  struct ArmTools {
    explicit ArmTools(const ScenePlacementWorld::Arm& arm)
        : grasp(arm.grasp),
          X_TO(arm.grasp.X_OT.inverse()),
          collisions(arm.checker->makeContext()),
          hand(*arm.hand),
          ik(makeInverseKinematics(arm.robot, kIkTolerance)),
          chain(arm.robot) {}

    Grasp grasp;
    Eigen::Isometry3d X_TO;
    std::unique_ptr<CollisionContext> collisions;
    FloatingBody hand;
    std::unique_ptr<InverseKinematics> ik;
    KinematicChain chain;
    Eigen::VectorXd answer;
  };

  ArmTools& tools(GraspId arm) { return *arms_.at(static_cast<std::size_t>(arm)); }

  FloatingBody object_;
  Grasp object_grasp_;
  std::vector<std::unique_ptr<ArmTools>> arms_;
};

/// Each arm's motions with the object in its hand.
class ArmMotions : public GraspMotionChecker {
 public:
  explicit ArmMotions(std::vector<ScenePlacementWorld::Arm> arms) : arms_(std::move(arms)) {}
  std::unique_ptr<GraspMotionContext> makeContext() const override;

 private:
  std::vector<ScenePlacementWorld::Arm> arms_;
};

class ArmMotionContext : public GraspMotionContext {
 public:
  explicit ArmMotionContext(const std::vector<ScenePlacementWorld::Arm>& arms) {
    for (const auto& arm : arms) arms_.push_back({arm.grasp, arm.checker->makeContext()});
  }
  bool isFree(const double* q, GraspId grasp) override {
    Held& held = arm(grasp);
    return held.context->isFree(q, &held.grasp);
  }
  bool isEdgeFree(const double* q1, const double* q2, GraspId grasp) override {
    Held& held = arm(grasp);
    return held.context->isEdgeFree(q1, q2, &held.grasp);
  }
  double freeFraction(const double* q1, const double* q2, GraspId grasp) override {
    Held& held = arm(grasp);
    return held.context->freeFraction(q1, q2, &held.grasp);
  }

 private:
  struct Held {
    Grasp grasp;
    std::unique_ptr<CollisionContext> context;
  };

  Held& arm(GraspId number) {
    if (number < 0 || static_cast<std::size_t>(number) >= arms_.size())
      throw std::invalid_argument("no arm has the number " + std::to_string(number));
    return arms_[static_cast<std::size_t>(number)];
  }

  std::vector<Held> arms_;
};

std::unique_ptr<GraspMotionContext> ArmMotions::makeContext() const {
  return std::make_unique<ArmMotionContext>(arms_);
}

}  // namespace

ScenePlacementWorld::ScenePlacementWorld(const Scene& scene) : geometry_(scene) {
  const std::vector<PlacementArm>& sources = scene.placing().arms;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    arms_.push_back(makeArm(scene, i));
    if (arms_.back().robot->dof() != arms_.front().robot->dof())
      throw InputError(scene.file, sources[i].name, "has another number of joints than the first arm");
  }
  object_ = FloatingBody::makeChecker(problemOf(scene, arms_.front().robot), FloatingBody::Parts::kObject);
}

Eigen::Isometry3d ScenePlacementWorld::objectPose(const Placement& placement) const {
  Eigen::Isometry3d X_WF = Eigen::Isometry3d::Identity();
  X_WF.linear() = Eigen::AngleAxisd(placement.angle_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  X_WF.translation() << placement.p_WV, regions()[static_cast<std::size_t>(placement.region)].height_m;
  return X_WF * geometry_.faces()[static_cast<std::size_t>(placement.face)].X_FO;
}

bool ScenePlacementWorld::locate(const Eigen::Isometry3d& X_WO, Placement& placement) const {
  constexpr double kFullTurn_rad = 2.0 * 3.14159265358979323846;
  for (int i = 0; i < faceCount(); ++i) {
    const PlacementFace& face = geometry_.faces()[static_cast<std::size_t>(i)];
    if (-(X_WO.linear() * face.normal_O).z() < std::cos(kLevel_rad)) continue;
    const Eigen::Vector3d p_WV = X_WO * face.vertices_O.front();
    const int region = geometry_.surfaces().regionAt(p_WV);
    if (region < 0) continue;
    const Eigen::Matrix3d R_WF = X_WO.linear() * face.X_FO.linear().transpose();
    const double angle = std::atan2(R_WF(1, 0), R_WF(0, 0));
    placement.arm = kNoGrasp;
    placement.face = i;
    placement.region = region;
    placement.p_WV = p_WV.head<2>();
    placement.angle_rad = angle < 0.0 ? angle + kFullTurn_rad : angle;
    return true;
  }
  return false;
}

bool ScenePlacementWorld::stable(const Eigen::Isometry3d& X_WO) const {
  const auto touches = [&](const Eigen::Vector3d& p_O) {
    return geometry_.surfaces().regionAt(X_WO * p_O) >= 0;
  };
  return std::any_of(geometry_.faces().begin(), geometry_.faces().end(), [&](const PlacementFace& face) {
    return -(X_WO.linear() * face.normal_O).z() >= std::cos(kLevel_rad) &&
           std::all_of(face.vertices_O.begin(), face.vertices_O.end(), touches);
  });
}

std::unique_ptr<PlacementContext> ScenePlacementWorld::makeContext() const {
  return std::make_unique<Context>(arms_, *object_);
}

std::shared_ptr<const GraspMotionChecker> ScenePlacementWorld::motions() const {
  return std::make_shared<ArmMotions>(arms_);
}

}  // namespace b4p
