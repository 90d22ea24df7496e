// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>

#include "experiments/configuration_counts.h"
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
      : checker_(std::move(checker)),
        region_(std::move(region)),
        configurations_(std::make_shared<ConfigurationCounts>()) {}

  std::unique_ptr<GraspMotionContext> makeContext() const override;

  /// Configurations that all contexts together have looked at, those along motions included.
  std::uint64_t configurationsChecked() const { return configurations_->total(); }

 private:
  std::shared_ptr<const CollisionChecker> checker_;
  std::shared_ptr<const SceneRegion> region_;
  std::shared_ptr<ConfigurationCounts> configurations_;  ///< contexts outlive the checker
};

}  // namespace b4p
