// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "experiments/scene.h"

namespace b4p {

/// Finds scenes that no planner can solve, before any planning. Takes less than a second on a sound scene,
/// seconds on one that is refused.
/// @throws InputError when the object collides at its start pose, none of many grasps drawn is valid there
/// (with the
///   commonest reason), or no placement drawn can be reached with any grasp that is
void preflight(const Scene& scene);

/// What becomes of a number of grasps drawn at the pick.
struct PickSurvey {
  int drawn = 0;
  int valid = 0;
};

/// Draws `count` grasps (of a finite family: each once) and counts those with a valid configuration at the
/// pick.
PickSurvey surveyPicks(const Scene& scene, int count, std::uint64_t seed);

}  // namespace b4p
