// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "experiments/scene_region.h"
#include "planners/grasp_motion_checker.h"
#include "state_validity/collision_checker.h"

namespace b4p {

/// Answers the planners' questions about motions under a grasp id through a collision checker and the grasps
/// known to a region.
class SceneMotionChecker : public GraspMotionChecker {
 public:
  SceneMotionChecker(std::shared_ptr<const CollisionChecker> checker,
                     std::shared_ptr<const SceneRegion> region)
      : checker_(std::move(checker)), region_(std::move(region)) {}

  std::unique_ptr<GraspMotionContext> makeContext() const override;

 private:
  std::shared_ptr<const CollisionChecker> checker_;
  std::shared_ptr<const SceneRegion> region_;
};

}  // namespace b4p
