// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/scene_region.h"

#include <algorithm>
#include <optional>
#include <random>
#include <utility>

#include "experiments/floating_body.h"
#include "experiments/hand_sieve.h"
#include "experiments/retreat.h"

namespace b4p {
namespace {

/// Inverse-kinematics attempts per root, and how many answers that collide are tried again from another seed:
/// a redundant arm reaches a pose with many postures.
constexpr int kIkAttempts = 32;
constexpr int kPostures = 3;

constexpr IkTolerance kIkTolerance{1e-5, 1e-4};

/// How far from where it was drawn the object may end up: the inverse kinematics' error, seen from a TCP half
/// a metre away.
constexpr double kPlacementMargin_m = 1e-4;

/// A tilt below this is upright: the inverse kinematics' error with room for rounding.
constexpr double kUprightTolerance_rad = 5e-4;

}  // namespace

SceneRegion::SceneRegion(const Scene& scene, std::shared_ptr<const CollisionChecker> checker)
    : SceneRegion(
          scene, checker,
          makeGraspSampler(scene.pickPlace().grasps, checker->problem().robot->description().max_opening_m)) {
}

SceneRegion::SceneRegion(const Scene& scene, std::shared_ptr<const CollisionChecker> checker,
                         std::unique_ptr<const GraspSampler> grasps)
    : checker_(std::move(checker)),
      gripper_checker_(
          FloatingBody::makeChecker(checker_->problem(), FloatingBody::Parts::kGripper, *checker_)),
      bare_hand_checker_(HandSieve::makeChecker(checker_->problem(), *checker_)),
      robot_(checker_->problem().robot),
      X_WO_start_(scene.pickPlace().X_WO_start),
      sampler_(std::move(grasps)),
      placement_sampler_(scene.pickPlace().placement, scene.pickPlace().X_WO_start, kPlacementMargin_m,
                         kUprightTolerance_rad) {
  for (const Grasp& grasp : sampler_->all()) grasps_.add(grasp);
}

std::unique_ptr<PickPlaceContext> SceneRegion::makeContext(std::uint64_t seed) const {
  return makeSceneContext(seed);
}

std::unique_ptr<SceneRegionContext> SceneRegion::makeSceneContext(std::uint64_t seed) const {
  return std::make_unique<SceneRegionContext>(*this, seed);
}

Eigen::Isometry3d SceneRegion::objectPose(const double* q, const Grasp& grasp) const {
  return robot_->tcpPose(q) * grasp.X_OT.inverse();
}

double SceneRegion::distanceToPlacement(const double* q, GraspId grasp) const {
  return placement_sampler_.distance(objectPose(q, grasps_.at(grasp)));
}

struct SceneRegionContext::Impl {
  Impl(const SceneRegion& region_in, const CollisionChecker& checker, const CollisionChecker& gripper_checker,
       std::uint64_t seed)
      : region(region_in),
        robot(checker.problem().robot),
        collisions(checker.makeContext()),
        gripper(gripper_checker),
        kinematics(makeInverseKinematics(robot, kIkTolerance)),
        retreat(robot, gripper),
        sieve(*region.sampler_, *region.bare_hand_checker_, gripper, retreat),
        random(seed) {}

  const SceneRegion& region;
  std::shared_ptr<const Manipulator> robot;
  std::unique_ptr<CollisionContext> collisions;
  FloatingBody gripper;
  std::unique_ptr<InverseKinematics> kinematics;
  Retreat retreat;
  HandSieve sieve;
  std::mt19937_64 random;
  Eigen::VectorXd answer;
};

SceneRegionContext::SceneRegionContext(const SceneRegion& region, std::uint64_t seed)
    : impl_(std::make_unique<Impl>(region, *region.checker_, *region.gripper_checker_, seed)) {}

SceneRegionContext::~SceneRegionContext() = default;

RootOutcome SceneRegionContext::root(const Eigen::Isometry3d& X_WO, const Grasp& grasp, double* q) {
  const Eigen::Isometry3d X_WT = X_WO * grasp.X_OT;
  if (!impl_->gripper.isFree(X_WT, grasp)) return RootOutcome::kGripperCollides;
  for (int posture = 0; posture < kPostures; ++posture) {
    if (!impl_->kinematics->solve(X_WT, impl_->random, kIkAttempts, impl_->answer))
      return posture == 0 ? RootOutcome::kUnreachable : RootOutcome::kArmCollides;
    if (!impl_->collisions->isFree(impl_->answer.data(), &grasp)) continue;
    std::copy_n(impl_->answer.data(), impl_->answer.size(), q);
    return RootOutcome::kValid;
  }
  return RootOutcome::kArmCollides;
}

bool SceneRegionContext::samplePick(double* q, GraspId& grasp) {
  const SceneRegion& region = impl_->region;
  if (region.finite()) {
    grasp = std::uniform_int_distribution<GraspId>(0, region.graspCount() - 1)(impl_->random);
    return pickRoot(grasp, q);
  }
  return pickNew(region.sampler_->sample(impl_->random), q, grasp);
}

bool SceneRegionContext::samplePickFor(PlacementId placement, double* q, GraspId& grasp) {
  const SceneRegion& region = impl_->region;
  if (region.finite()) return samplePick(q, grasp);
  const std::optional<Grasp> drawn = impl_->sieve.draw(region.placement(placement), impl_->random);
  return drawn && pickNew(*drawn, q, grasp);
}

bool SceneRegionContext::pickNew(const Grasp& drawn, double* q, GraspId& grasp) {
  if (root(impl_->region.X_WO_start_, drawn, q) != RootOutcome::kValid) return false;
  grasp = impl_->region.grasps_.add(drawn);
  return true;
}

bool SceneRegionContext::pickRoot(GraspId grasp, double* q) {
  return root(impl_->region.X_WO_start_, impl_->region.grasp(grasp), q) == RootOutcome::kValid;
}

PlacementId SceneRegionContext::samplePlacement() {
  return impl_->region.placements_.add(impl_->region.placement_sampler_.sample(impl_->random));
}

bool SceneRegionContext::placeRoot(PlacementId placement, GraspId grasp, double* q) {
  return root(impl_->region.placement(placement), impl_->region.grasp(grasp), q) == RootOutcome::kValid;
}

int SceneRegionContext::retreatDirections() const { return Retreat::kDirections; }

void SceneRegionContext::retreatReach(const double* q, GraspId grasp, int steps, int* reach) {
  impl_->retreat.handReach(impl_->robot->tcpPose(q), impl_->region.grasp(grasp), steps, reach);
}

bool SceneRegionContext::retreat(const double* q, GraspId, int direction, double* next) {
  return impl_->retreat.step(q, direction, next);
}

RootOutcome SceneRegionContext::pick(const Grasp& grasp, double* q, std::string& collision) {
  const Eigen::Isometry3d& X_WO = impl_->region.X_WO_start_;
  const RootOutcome outcome = root(X_WO, grasp, q);
  if (outcome == RootOutcome::kGripperCollides)
    collision = impl_->gripper.describeCollision(X_WO * grasp.X_OT, grasp);
  if (outcome == RootOutcome::kArmCollides)
    collision = impl_->collisions->describeCollision(impl_->answer.data(), &grasp);
  return outcome;
}

RootOutcome SceneRegionContext::tryPick(GraspId grasp, double* q, std::string& collision) {
  return pick(impl_->region.grasp(grasp), q, collision);
}

RootOutcome SceneRegionContext::tryPlacement(GraspId grasp, double* q) {
  const Eigen::Isometry3d X_WO = impl_->region.placement_sampler_.sample(impl_->random);
  return root(X_WO, impl_->region.grasp(grasp), q);
}

RootOutcome SceneRegionContext::probePick(Grasp& grasp, std::string& collision) {
  grasp = impl_->region.sampler_->sample(impl_->random);
  std::vector<double> q(static_cast<std::size_t>(impl_->robot->dof()));
  return pick(grasp, q.data(), collision);
}

bool SceneRegionContext::reachesSomePlacement(const Grasp& grasp) {
  const Eigen::Isometry3d X_WO = impl_->region.placement_sampler_.sample(impl_->random);
  return impl_->kinematics->solve(X_WO * grasp.X_OT, impl_->random, kIkAttempts, impl_->answer);
}

}  // namespace b4p
