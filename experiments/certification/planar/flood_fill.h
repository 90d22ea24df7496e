// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "experiments/certification/planar/bit_volume.h"

namespace b4p::planar {

/// Spreads `reached` to every cell that is not blocked and touches a reached one by a face, an edge or a
/// corner (26 neighbours); the first and the last layer touch. Reached cells that are blocked are dropped
/// first. A continuous motion through cells that are not blocked never leaves what is reached.
/// @param stop  asked now and then; true ends the fill early
/// @return false when stopped
bool floodFill(const BitVolume& blocked, BitVolume& reached, const std::function<bool()>& stop);

}  // namespace b4p::planar
