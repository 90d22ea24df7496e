// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "experiments/problem.h"
#include "experiments/scene.h"

namespace b4p {

/// Finds scenes that no planner can solve, before any planning. Takes less than a second on a sound scene,
/// seconds on one that is refused.
/// @throws InputError as the requireSolvable() of the scene's problem does, or makePlacementProblem()
void preflight(const Scene& scene);

/// @throws InputError as Problem::requireSolvable() does
void requirePickAndPlaceSolvable(const Problem& problem);

}  // namespace b4p
