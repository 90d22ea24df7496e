// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "experiments/scene.h"

namespace b4p {

/// Finds scenes that no planner can solve, before any planning. Takes less than a second on a sound scene,
/// seconds on one that is refused.
/// @throws InputError when the object at its start pose is nearer to an obstacle than
///   contact_clearance_m, none of many grasps drawn is valid there
/// (with the
///   commonest reason), or no placement drawn can be reached with any grasp that is
void preflight(const Scene& scene);

}  // namespace b4p
