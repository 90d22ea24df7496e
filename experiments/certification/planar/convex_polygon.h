// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace b4p::planar {

/// Corners of a convex polygon, counter-clockwise, no three in line (m).
using Polygon = std::vector<Eigen::Vector2d>;

/// The points p with normal . p <= offset.
struct HalfPlane {
  Eigen::Vector2d normal;  ///< unit vector
  double offset = 0.0;     ///< m
};

/// Convex hull (monotone chain); fewer than three corners when the points span no area.
Polygon convexHull(std::vector<Eigen::Vector2d> points);

/// Turned about the origin.
Polygon turned(const Polygon& polygon, double angle_rad);

/// Where the origin of a moving convex body may not be: all w - m with w in `fixed` and m in `moving`, that
/// is, the positions at which the two overlap. Both need an area.
Polygon overlapPositions(const Polygon& fixed, const Polygon& moving);

/// Points p such that p + d lies in the polygon for every d in a square of half side `half_square_m` (sides
/// along x and y) plus a disc of radius `disc_m`: one half-plane an edge, whose intersection may be empty.
std::vector<HalfPlane> eroded(const Polygon& polygon, double half_square_m, double disc_m);

/// Largest distance of a corner from the origin (m).
double farthestCorner(const Polygon& polygon);

}  // namespace b4p::planar
