// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "experiments/certification/planar/convex_polygon.h"
#include "robots/shape.h"

namespace b4p::planar {

/// Points of a shape whose convex hull lies inside it, in its own frame: the corners of boxes and meshes, so
/// that the hull is all of the shape; for round shapes the hull is slightly smaller.
std::vector<Eigen::Vector3d> innerPoints(const Shape& shape);

/// The hull of the points cut at height z, as a polygon in x and y; fewer than three corners when the
/// cut has no area.
Polygon cutAt(const std::vector<Eigen::Vector3d>& points, double z);

}  // namespace b4p::planar
