// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "robots/shape.h"

namespace b4p {

// Pieces of a scene file's text. Lengths in metres.

/// A number with up to so many decimals, without trailing zeros, whatever the locale.
std::string sceneNumber(double value, int decimals = 5);

/// [a, b, c]
std::string sceneList(const std::vector<double>& values);
std::string sceneList(const Eigen::Vector3d& values);

/// The text as comment lines, broken at spaces.
std::string commentLines(const std::string& text);

/// One obstacle on one line.
std::string boxLine(const std::string& name, const Eigen::Vector3d& size_m, const Eigen::Vector3d& centre_m);
std::string cylinderLine(const std::string& name, double radius_m, double length_m,
                         const Eigen::Vector3d& centre_m);

/// One obstacle of any shape but a mesh, at X_BS in the world, on one line.
/// @throws std::invalid_argument for a mesh
std::string shapeLine(const std::string& name, const PlacedShape& placed);

/// One obstacle that is a mesh in a file beside the scene.
std::string meshLine(const std::string& name, const std::string& file, bool convex_hull);

/// The box between two corners.
std::string boxBetween(const std::string& name, const Eigen::Vector3d& low_m, const Eigen::Vector3d& high_m);

}  // namespace b4p
