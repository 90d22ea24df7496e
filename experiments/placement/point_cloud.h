// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace b4p {

/// Points (m) of a PLY or PCD file, told apart by its first word: PLY in ASCII or binary of either byte
/// order, PCD in ASCII or `DATA binary`. Other properties than x, y and z are skipped, and so are points of
/// which all three are NaN: they stand for a measurement that is missing.
/// @throws InputError naming file, line or point, and value: unreadable file, another format (PCD's
///   binary_compressed among them), malformed header, no points, fewer of them than the header says, a
///   coordinate that is missing, no number, not finite or farther than 1000 m
std::vector<Eigen::Vector3d> readPointCloud(const std::string& file);

}  // namespace b4p
