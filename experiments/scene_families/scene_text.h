// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace b4p {

// Pieces of a scene file's text. Lengths in metres.

/// A number with up to five decimals, without trailing zeros, whatever the locale.
std::string sceneNumber(double value);

/// [a, b, c]
std::string sceneList(const std::vector<double>& values);
std::string sceneList(const Eigen::Vector3d& values);

/// The text as comment lines, broken at spaces.
std::string commentLines(const std::string& text);

/// One obstacle on one line.
std::string boxLine(const std::string& name, const Eigen::Vector3d& size_m, const Eigen::Vector3d& centre_m);
std::string cylinderLine(const std::string& name, double radius_m, double length_m,
                         const Eigen::Vector3d& centre_m);

/// The box between two corners.
std::string boxBetween(const std::string& name, const Eigen::Vector3d& low_m, const Eigen::Vector3d& high_m);

}  // namespace b4p
