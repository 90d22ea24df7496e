// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "robots/shape.h"

namespace b4p {

/// A convex mesh that contains every point within `padding_m` > 0 of `mesh` (its Minkowski sum with a ball).
///
/// Every face moves outwards by the padding, and sharp edges are cut off at the same distance, so that the
/// result keeps to within padding_m of flat faces and a little more (at most by a factor of about 1.2 across
/// an edge) elsewhere.
/// @throws std::invalid_argument if the mesh encloses no volume.
std::shared_ptr<const ConvexMesh> grownMesh(const ConvexMesh& mesh, double padding_m);

}  // namespace b4p
