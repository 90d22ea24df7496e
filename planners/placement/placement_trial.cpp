// SPDX-License-Identifier: BSD-3-Clause
#include "planners/placement/placement_trial.h"

namespace b4p {
namespace {

/// The pose alone, cheap tests first. All of stability and freedom is tested where each is worth a part of
/// the reward.
void tryPose(const PlacementWorld& world, const PlacementObjective& objective,
             const PlacementOptions& options, PlacementContext& context, const Eigen::Isometry3d& X_WO,
             double threshold, PlacementOutcome& outcome) {
  outcome.stable = world.stable(X_WO);
  if (options.reward != PlacementReward::kPaper) {
    if (!outcome.stable) return;
    outcome.hopeless = objective.quickBound(X_WO) <= threshold;  // false for NaN: the value will tell
    if (outcome.hopeless) return;
  }
  outcome.object_free = context.objectFree(X_WO);
  if (!outcome.stable || !outcome.object_free) return;
  outcome.objective = objective.value(X_WO);
  outcome.better = outcome.objective > threshold;
}

void tryArm(const PlacementOptions& options, PlacementContext& context, GraspId arm,
            const Eigen::Isometry3d& X_WO, std::uint64_t seed, double* q, PlacementOutcome& outcome) {
  outcome.hand_free = !options.hand_first || context.handFree(arm, X_WO);
  if (!outcome.hand_free) return;
  std::mt19937_64 random(seed);
  for (unsigned posture = 0; posture < options.postures && !outcome.arm_free; ++posture) {
    bool answered = false;
    for (unsigned i = 0; i < options.ik_attempts && !answered; ++i)
      answered = context.inverse(arm, X_WO, random, q);
    if (!answered) return;
    outcome.reachable = true;
    outcome.arm_free = context.armFree(arm, q);
  }
}

}  // namespace

PlacementOutcome tryPlacement(const PlacementWorld& world, const PlacementObjective& objective,
                              const PlacementOptions& options, PlacementContext& context,
                              const Placement& placement, double threshold, std::uint64_t seed, double* q) {
  PlacementOutcome outcome;
  const Eigen::Isometry3d X_WO = world.objectPose(placement);
  if (!options.pose_first) tryArm(options, context, placement.arm, X_WO, seed, q, outcome);
  tryPose(world, objective, options, context, X_WO, threshold, outcome);
  if (options.pose_first && outcome.better) tryArm(options, context, placement.arm, X_WO, seed, q, outcome);
  return outcome;
}

void countOutcome(const PlacementOutcome& outcome, const PlacementOptions& options,
                  PlacementStatistics& statistics) {
  ++statistics.draws;
  const auto countPose = [&] {
    if (!outcome.stable)
      ++statistics.unstable;
    else if (outcome.hopeless)
      ++statistics.not_better;
    else if (!outcome.object_free)
      ++statistics.object_collides;
    else
      ++statistics.not_better;
  };
  if (outcome.valid())
    ++statistics.valid;
  else if (options.pose_first && !outcome.better)
    countPose();
  else if (!outcome.hand_free)
    ++statistics.hand_collides;
  else if (!outcome.reachable)
    ++statistics.unreachable;
  else if (!outcome.arm_free)
    ++statistics.arm_collides;
  else
    countPose();
}

}  // namespace b4p
