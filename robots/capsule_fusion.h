// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "robots/shape.h"

namespace b4p {

/// URDF has no capsules. Replaces each cylinder that has spheres of its own radius at both ends by the
/// capsule that the three make up; other shapes stay as they are, in their order.
void fuseCapsules(std::vector<PlacedShape>& shapes);

}  // namespace b4p
