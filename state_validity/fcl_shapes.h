// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include <fcl/geometry/collision_geometry.h>

#include "robots/shape.h"

namespace b4p {

using FclShape = std::shared_ptr<const fcl::CollisionGeometryd>;

/// The shape as FCL knows it, in the same frame S. Immutable and safe to share between threads.
FclShape fclShape(const Shape& shape);

}  // namespace b4p
