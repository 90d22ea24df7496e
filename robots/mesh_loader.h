// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "robots/shape.h"

namespace b4p {

/// File that a mesh's address in a URDF means: `package://NAME/rest` (NAME is looked for upwards from
/// `folder`, then in ROS_PACKAGE_PATH), `file:///absolute`, or a path, absolute or relative to `folder`.
/// @throws std::runtime_error saying what is missing.
std::string meshFile(const std::string& address, const std::string& folder);

/// Convex hull of everything in a mesh file (whatever assimp reads; STL, OBJ and DAE are tested), scaled
/// along its axes. Units stated in the file count; a stated up-direction does not, as is usual in ROS.
/// @throws std::runtime_error when the file cannot be read, holds no triangles, or spans no volume.
std::shared_ptr<const ConvexMesh> loadMeshHull(const std::string& file, const Eigen::Vector3d& scale);

/// The same for a mesh that has to be convex itself (within 1e-6 m) and in one part.
/// @throws std::runtime_error also when it is not.
std::shared_ptr<const ConvexMesh> loadConvexMesh(const std::string& file, const Eigen::Vector3d& scale);

}  // namespace b4p
