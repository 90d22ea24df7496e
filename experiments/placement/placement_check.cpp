// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/placement_check.h"

#include "experiments/placement/clearance_objective.h"
#include "experiments/verification/placement_verifier.h"
#include "robots/input_error.h"

namespace b4p {

void verifyImprovements(const Scene& scene, PlacementResult& result) {
  const bool largest = clearanceGoal(result.objective, scene.file, "objective") == ClearanceGoal::kLargest;
  bool same_arms = result.arms.size() == scene.placing().arms.size();
  for (std::size_t i = 0; same_arms && i < result.arms.size(); ++i)
    same_arms = result.arms[i] == scene.placing().arms[i].name;
  if (!same_arms) throw InputError(scene.file, "place.arms", "are not the arms of the result");
  const PlacementVerifier verifier(scene, largest ? 1.0 : -1.0);
  for (PlacementImprovement& improvement : result.improvements)
    improvement.verification =
        verifier.verify(improvement, result.joint_names[static_cast<std::size_t>(improvement.arm)]);
}

std::string firstFailure(const PlacementResult& result) {
  for (std::size_t i = 0; i < result.improvements.size(); ++i) {
    const PlacementImprovement& improvement = result.improvements[i];
    const std::string name = "improvement " + std::to_string(i) + ": ";
    if (!improvement.verification.passed) return name + improvement.verification.failure;
    if (i == 0) continue;
    if (!(improvement.objective_m > result.improvements[i - 1].objective_m))
      return name + "is no better than the one before";
    if (!(improvement.time_s >= result.improvements[i - 1].time_s))
      return name + "is earlier than the one before";
  }
  return "";
}

}  // namespace b4p
