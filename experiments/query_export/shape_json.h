// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "experiments/json_value.h"
#include "robots/shape.h"

namespace b4p {

/// A shape with its pose in the frame of its body, under the key `pose_key`. A mesh, which stands for its
/// convex hull, is the list of the hull's vertices.
/// @throws std::invalid_argument when the pose is not finite
Json shapeJson(const PlacedShape& placed, const char* pose_key);

}  // namespace b4p
