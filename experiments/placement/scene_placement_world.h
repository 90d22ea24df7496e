// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "experiments/placement/placement_geometry.h"
#include "experiments/scene.h"
#include "planners/grasp_motion_checker.h"
#include "planners/placement/placement_world.h"
#include "state_validity/collision_checker.h"

namespace b4p {

/// A placement scene as planners see it. Arms have the numbers of the task's list. Immutable; keeps what its
/// contexts need.
class ScenePlacementWorld : public PlacementWorld {
 public:
  /// One arm with its grasp.
  struct Arm {
    std::shared_ptr<const Manipulator> robot;
    std::shared_ptr<const CollisionChecker> checker;  ///< of the arm and the object it holds, others at rest
    std::shared_ptr<const CollisionChecker> hand;     ///< of the hand and the object alone
    Grasp grasp;
  };

  /// @param scene  with a placement task
  /// @throws InputError as PlacementGeometry does, and when a robot's files are at fault
  explicit ScenePlacementWorld(const Scene& scene);

  unsigned dof() const override { return static_cast<unsigned>(arms_.front().robot->dof()); }
  GraspId armCount() const override { return static_cast<GraspId>(arms_.size()); }
  int faceCount() const override { return static_cast<int>(geometry_.faces().size()); }
  const std::vector<ContactRegion>& regions() const override { return geometry_.surfaces().regions(); }
  Eigen::Isometry3d objectPose(const Placement& placement) const override;
  bool locate(const Eigen::Isometry3d& X_WO, Placement& placement) const override;
  bool stable(const Eigen::Isometry3d& X_WO) const override;
  std::unique_ptr<PlacementContext> makeContext() const override;

  const PlacementGeometry& geometry() const { return geometry_; }
  const std::vector<Arm>& arms() const { return arms_; }

  /// Motions of the arms with the object, grasp id = arm.
  std::shared_ptr<const GraspMotionChecker> motions() const;

 private:
  PlacementGeometry geometry_;
  std::vector<Arm> arms_;
  std::shared_ptr<const CollisionChecker> object_;  ///< of the object alone
};

}  // namespace b4p
