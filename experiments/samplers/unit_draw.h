// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

namespace b4p {

/// Uniform in [0, 1), the same on every platform.
inline double unitDraw(std::mt19937_64& random) {
  constexpr int kDropped = 11;  // of 64 bits, to keep the 53 that a double holds
  constexpr double kScale = 1.0 / 9007199254740992.0;
  return static_cast<double>(random() >> kDropped) * kScale;
}

}  // namespace b4p
