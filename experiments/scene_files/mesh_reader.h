// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "robots/shape.h"

namespace b4p {

/// A mesh file cannot be used; what() says why.
class MeshError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads a mesh (STL, OBJ, ...; vertices in metres once scaled). With `take_hull` its convex hull stands for
/// it; without, the mesh has to be convex.
/// @throws MeshError
std::shared_ptr<const ConvexMesh> readConvexMesh(const std::string& file, const Eigen::Vector3d& scale,
                                                 bool take_hull);

}  // namespace b4p
