// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "experiments/floating_body.h"
#include "experiments/retreat.h"
#include "experiments/samplers/grasp_sampler.h"

namespace b4p {

/// Draws grasps that the hand alone, without its arm, could let go of at a given pose of the object: the
/// cheapest test there is, often one that few grasps pass. One object per thread.
class HandSieve {
 public:
  /// The checker of bare hands behind such objects, shared by all threads.
  /// @param like  of which kind
  static std::shared_ptr<const CollisionChecker> makeChecker(const CollisionProblem& problem,
                                                             const CollisionChecker& like);

  /// All outlive this object.
  /// @param bare_hands  of makeChecker()
  /// @param gripper     the hand with what it holds
  HandSieve(const GraspSampler& sampler, const CollisionChecker& bare_hands, FloatingBody& gripper,
            Retreat& retreat);

  /// A grasp whose hand is free around the object at X_WO. Mostly it has a straight way out, where one of a
  /// few draws has; a hand without one may still turn out of its place, so that in one of four calls the
  /// first that is free will do. Nothing when no hand was free.
  std::optional<Grasp> draw(const Eigen::Isometry3d& X_WO, std::mt19937_64& random);

 private:
  void sift(const Eigen::Isometry3d& X_WO);
  bool leaves(const Eigen::Isometry3d& X_WT, const Grasp& grasp);

  const GraspSampler& sampler_;
  FloatingBody bare_hands_;
  FloatingBody& gripper_;
  Retreat& retreat_;
  std::vector<Grasp> drawn_;
  std::vector<bool> fits_;
  std::vector<std::size_t> alike_;
  std::vector<Eigen::Isometry3d> X_WT_;
  std::vector<bool> free_;
};

}  // namespace b4p
