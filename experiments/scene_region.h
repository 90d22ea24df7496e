// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "experiments/append_only_table.h"
#include "experiments/samplers/grasp_sampler.h"
#include "experiments/samplers/placement_sampler.h"
#include "experiments/scene.h"
#include "planners/pick_place_region.h"
#include "robots/inverse_kinematics.h"
#include "state_validity/collision_checker.h"

namespace b4p {

class SceneRegionContext;

/// The picks and placements of a scene, through inverse kinematics. Grasps of a finite family are all known
/// from the start, with their number in the family as id; of a continuum, a grasp becomes known when
/// samplePick() finds a valid configuration for it.
class SceneRegion : public PickPlaceRegion {
 public:
  /// @param checker  of the robot carrying the scene's object
  SceneRegion(const Scene& scene, std::shared_ptr<const CollisionChecker> checker);

  /// With other grasps than the scene's.
  SceneRegion(const Scene& scene, std::shared_ptr<const CollisionChecker> checker,
              std::unique_ptr<const GraspSampler> grasps);

  std::unique_ptr<PickPlaceContext> makeContext(std::uint64_t seed) const override;
  GraspId graspCount() const override { return grasps_.size(); }
  double distanceToPlacement(const double* q, GraspId grasp) const override;

  /// The same context as makeContext() gives, by its own type.
  std::unique_ptr<SceneRegionContext> makeSceneContext(std::uint64_t seed) const;

  /// True when all grasps are known from the start.
  bool finite() const { return !sampler_->all().empty(); }

  /// @throws std::invalid_argument for an unknown id. The reference stays good as long as the region.
  const Grasp& grasp(GraspId id) const { return grasps_.at(id); }
  const Eigen::Isometry3d& placement(PlacementId id) const { return placements_.at(id); }

  /// Pose X_WO of the object held with a grasp at q.
  Eigen::Isometry3d objectPose(const double* q, const Grasp& grasp) const;

 private:
  friend class SceneRegionContext;

  std::shared_ptr<const CollisionChecker> checker_;
  std::shared_ptr<const CollisionChecker> gripper_checker_;
  std::shared_ptr<const CollisionChecker> bare_hand_checker_;
  std::shared_ptr<const Manipulator> robot_;
  Eigen::Isometry3d X_WO_start_;
  std::unique_ptr<const GraspSampler> sampler_;
  PlacementSampler placement_sampler_;
  mutable AppendOnlyTable<Grasp> grasps_;
  mutable AppendOnlyTable<Eigen::Isometry3d> placements_;
};

/// Why a drawn grasp or placement gave a configuration or not.
enum class RootOutcome { kValid, kGripperCollides, kUnreachable, kArmCollides };

/// One thread's draws from a SceneRegion.
class SceneRegionContext : public PickPlaceContext {
 public:
  SceneRegionContext(const SceneRegion& region, std::uint64_t seed);
  ~SceneRegionContext() override;

  bool samplePick(double* q, GraspId& grasp) override;
  bool samplePickFor(PlacementId placement, double* q, GraspId& grasp) override;
  PlacementId samplePlacement() override;
  bool placeRoot(PlacementId placement, GraspId grasp, double* q) override;
  int retreatDirections() const override;
  void retreatReach(const double* q, GraspId grasp, int steps, int* reach) override;
  bool retreat(const double* q, GraspId grasp, int direction, double* next) override;

  /// A configuration that holds the object at its start pose with a known grasp.
  bool pickRoot(GraspId grasp, double* q);

  /// Tries to hold the object at its start pose with a known grasp.
  /// @param collision  set to the colliding pair where that is the outcome
  RootOutcome tryPick(GraspId grasp, double* q, std::string& collision);

  /// Tries a known grasp at a placement that is drawn and forgotten.
  RootOutcome tryPlacement(GraspId grasp, double* q);

  /// Draws a grasp without adding it to the known ones, and tries it at the start pose.
  /// @param collision  set to the colliding pair where that is the outcome
  RootOutcome probePick(Grasp& grasp, std::string& collision);

  /// Whether inverse kinematics has an answer, collisions aside, for a placement that is drawn and forgotten.
  bool reachesSomePlacement(const Grasp& grasp);

 private:
  bool pickNew(const Grasp& drawn, double* q, GraspId& grasp);
  RootOutcome root(const Eigen::Isometry3d& X_WO, const Grasp& grasp, double* q);
  RootOutcome pick(const Grasp& grasp, double* q, std::string& collision);

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace b4p
