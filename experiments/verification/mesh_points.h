// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace b4p::verification {

/// All corner points of a mesh file (STL, OBJ, DAE: what assimp reads), each once, in the file's units.
/// @param reference  `package://NAME/rest`, looked up upwards from the URDF's folder and then in
///                   ROS_PACKAGE_PATH; `file://` and a path; or a path, relative to the URDF's folder
/// @param urdf_file, element  named in errors
/// @throws InputError when the file is missing or holds no points.
std::vector<Eigen::Vector3d> readMeshPoints(const std::string& reference, const std::string& urdf_file,
                                            const std::string& element);

}  // namespace b4p::verification
