// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "robots/grasp.h"

namespace b4p {

/// Reads poses from a file of comma-separated numbers: a pose a line, 16 numbers, the rows of its 4x4 matrix
/// one after the other. Rotations come out orthonormal to rounding.
/// @throws InputError naming row and value: no such file, a row that has not 16 numbers, a text that is none
///   or not finite, a rotation that is off by more than 1e-4, a last row that is not 0 0 0 1, no row at all
std::vector<Eigen::Isometry3d> readGraspTable(const std::string& file);

/// The same with a 17th number in each row: the distance between the finger pads (m).
/// @throws InputError as readGraspTable() does, and for an opening outside [0, max_opening_m]
std::vector<Grasp> readHoldingTable(const std::string& file, double max_opening_m);

}  // namespace b4p
