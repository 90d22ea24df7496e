// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "experiments/json_value.h"
#include "experiments/placement/placement_result.h"

namespace b4p {

/// Whether a document is what writePlacementResult() writes, rather than writeResult().
bool isPlacementResult(const Json& document);

/// What a result file says, its statistics of draws left aside.
/// @throws InputError naming file and element, as readResult() does; also where `best` is not the last
///   improvement
PlacementResult placementResultFrom(const JsonValue& root);

}  // namespace b4p
