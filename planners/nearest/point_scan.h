// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace b4p {

/// Points that are looked at together.
constexpr std::size_t kBlockPoints = 16;

/// Points in R^dimension, in single precision: [block][coordinate][kBlockPoints], aligned to 64 bytes.
struct PointBlocks {
  const float* values;
  std::size_t count;
  int dimension;
};

/// The first block, from `block` on, with a point whose squared distance from q is not above `limit`;
/// the number of blocks when there is none. `squares` receives the squared distances of its points. Points
/// from `count` on may be written meanwhile: what is read of them has no effect.
std::size_t firstBlockWithin(const PointBlocks& points, const float* q, float limit, std::size_t block,
                             float* squares);

/// Name of the instruction set in use, "AVX2" for example.
const char* scanInstructionSet();

}  // namespace b4p
