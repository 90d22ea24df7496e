// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "robots/shape.h"

namespace b4p {

/// A face that an object can stand on.
struct PlacementFace {
  Eigen::Vector3d normal_O = Eigen::Vector3d::Zero();  ///< outwards: points down when the object stands on it
  std::vector<Eigen::Vector3d> vertices_O;  ///< corners, counter-clockwise seen from outside; the first is
                                            ///< the reference vertex
  /// Pose of the object in the face's frame F: origin at the reference vertex, z into the object (the paper's
  /// fTo).
  Eigen::Isometry3d X_FO = Eigen::Isometry3d::Identity();
};

struct FaceRules {
  double cluster_rad = 0.18;   ///< triangles turned by less than this from the first one belong to its face
  double flat_m = 2e-4;        ///< vertices within this of the face's plane touch the ground
  double com_inside_m = 0.01;  ///< how far inside the face the centre of mass has to stand
};

/// The faces of an object's convex hull over which its centre of mass stands (paper, Section IV-A): the
/// hull's triangles are clustered around the largest one not yet taken. Largest face first.
/// @param points_O  points whose hull is the object's
/// @throws std::invalid_argument when the points span no volume
std::vector<PlacementFace> placementFaces(const std::vector<Eigen::Vector3d>& points_O,
                                          const Eigen::Vector3d& p_OCom, const FaceRules& rules = {});

}  // namespace b4p
