// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "experiments/placement/point_file.h"

namespace b4p {

enum class PointEncoding { kText, kLittleEndian, kBigEndian };

/// A binary number.
struct NumberFormat {
  char kind = 'F';  ///< 'I' signed, 'U' unsigned, 'F' floating point
  std::size_t bytes = 4;
};

/// A value of every point, or several of one name side by side.
struct PointColumn {
  std::string name;
  NumberFormat format;
  std::size_t count = 1;
};

/// What the header of a point cloud says of what follows.
struct PointCloudHeader {
  std::size_t points = 0;  ///< at least one
  PointEncoding encoding = PointEncoding::kText;
  std::vector<PointColumn> columns;
  std::array<std::size_t, 3> xyz{};  ///< where the coordinates are in `columns`; each has one value
};

/// Reads the header of a PLY or PCD file. What comes next from the file are the points.
/// @throws InputError
PointCloudHeader readPointCloudHeader(PointFile& file);

}  // namespace b4p
