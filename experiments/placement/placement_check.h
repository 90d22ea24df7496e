// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "experiments/placement/placement_result.h"
#include "experiments/scene.h"

namespace b4p {

/// Verifies every improvement (see PlacementVerifier) and stores the outcome with it.
/// @param scene  the one that the result is of
/// @throws InputError as PlacementVerifier does, and for an objective or arms that are not the scene's
void verifyImprovements(const Scene& scene, PlacementResult& result);

/// The first improvement that is not verified, one line; or that is no improvement on the one before, or
/// comes earlier. Empty when there is none.
std::string firstFailure(const PlacementResult& result);

}  // namespace b4p
