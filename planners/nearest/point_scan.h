// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace b4p {

/// Points lie in blocks of this many.
constexpr std::size_t kBlockPoints = 16;

/// Points in R^dimension, in single precision: [block][coordinate][kBlockPoints], aligned to 64 bytes.
struct PointBlocks {
  const float* values;
  std::size_t count;
  int dimension;
};

/// Writes the squared distances of the points from q, and infinity up to the end of the last block; returns
/// the least of them. Points from `count` on are not looked at: they may be written meanwhile.
float squaredDistances(const PointBlocks& points, const float* q, float* squares);

/// Index of the first, from `index` on, of the `count` squares (filled up to whole blocks) that is not above
/// `limit`; when there is none, a number that is at least `count`.
std::size_t firstWithin(const float* squares, std::size_t count, float limit, std::size_t index);

/// Name of the instruction set in use, "AVX2" for example.
const char* scanInstructionSet();

}  // namespace b4p
