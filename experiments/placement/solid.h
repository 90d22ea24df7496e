// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "robots/shape.h"

namespace b4p {

// Convex solids and objects made of them. Lengths in metres.

/// Whether a point of the shape's frame S lies inside the shape or within a nanometre of it.
bool containsPoint(const Shape& shape, const Eigen::Vector3d& p_S);

/// Volume (m^3) and centroid, in S.
struct VolumeCentroid {
  double volume_m3 = 0.0;
  Eigen::Vector3d p_S = Eigen::Vector3d::Zero();
};
VolumeCentroid volumeCentroid(const Shape& shape);

/// Centre of mass of shapes of one density. Where shapes overlap, the overlap counts twice.
Eigen::Vector3d centreOfMass(const std::vector<PlacedShape>& shapes);

/// Points on the surfaces of shapes, in the frame of their body, whose convex hull is that of the shapes:
/// exact for boxes and meshes, from inside, with 64 points a turn, where surfaces are round.
std::vector<Eigen::Vector3d> hullPoints(const std::vector<PlacedShape>& shapes);

}  // namespace b4p
