// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace b4p {

/// A part of a mesh that is connected by common vertices.
struct MeshPiece {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;  ///< indices into `vertices`

  /// How far vertices lie on both sides of the plane of a triangle, at most (m): 0 for a convex piece.
  double concavity_m() const;
};

/// Reads the vertices and faces of a Wavefront OBJ file and takes it apart where no vertex number is shared,
/// in the order of the faces. Pieces that merely touch stay apart, for which assimp cannot be asked: it
/// numbers vertices anew for each face. Faces of more than three corners become fans.
/// @throws InputError naming the line: no such file, a number that is none or not finite, a face of fewer
/// than
///   three corners or with a vertex that is not there; no faces at all
std::vector<MeshPiece> readObjPieces(const std::string& file);

/// The text of an OBJ file.
std::string objText(const std::vector<Eigen::Vector3d>& vertices,
                    const std::vector<std::array<int, 3>>& triangles);

}  // namespace b4p
