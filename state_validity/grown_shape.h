// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "robots/shape.h"

namespace b4p {

/// A shape in the same frame S that contains every point within `padding_m` >= 0 of `shape`. Spheres and
/// capsules grow exactly; boxes and cylinders grow by the padding on every side and keep their sharp edges;
/// meshes see grownMesh.
Shape grownShape(const Shape& shape, double padding_m);

}  // namespace b4p
