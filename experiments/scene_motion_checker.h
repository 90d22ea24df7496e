// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
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
      : checker_(std::move(checker)),
        region_(std::move(region)),
        configurations_(std::make_shared<std::atomic<std::uint64_t>>(0)) {}

  std::unique_ptr<GraspMotionContext> makeContext() const override;

  /// Configurations that all contexts together have looked at, those along motions included.
  std::uint64_t configurationsChecked() const { return configurations_->load(std::memory_order_relaxed); }

 private:
  std::shared_ptr<const CollisionChecker> checker_;
  std::shared_ptr<const SceneRegion> region_;
  std::shared_ptr<std::atomic<std::uint64_t>> configurations_;  ///< contexts outlive the checker
};

}  // namespace b4p
