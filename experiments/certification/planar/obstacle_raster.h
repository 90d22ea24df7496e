// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "experiments/certification/planar/bit_volume.h"
#include "experiments/certification/planar/convex_polygon.h"
#include "experiments/certification/planar/se2_grid.h"

namespace b4p::planar {

/// Convex pieces at one height: those of a body, in its own frame, and those that are fixed, in the world.
struct Slice {
  std::vector<Polygon> moving;
  std::vector<Polygon> fixed;
};

/// Marks, in one layer of `blocked`, cells at whose every pose a moving piece overlaps a fixed one. Cells
/// that are not marked may be free or not.
///
/// At the layer's middle angle the positions of overlap of two convex pieces are a convex polygon. Turned by
/// at most half a layer, no point of the moving piece travels farther than its farthest corner times that
/// angle, so each support line of the polygon moves inwards by no more than that; and for all positions of a
/// cell to lie inside, its centre has to keep half a cell away as well. What is left, shrunk by a
/// further 10 um for rounding, is marked.
void markBlocked(const Slice& slice, const Se2Grid& grid, int layer, BitVolume& blocked);

}  // namespace b4p::planar
