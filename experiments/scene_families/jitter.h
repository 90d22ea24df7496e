// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "experiments/samplers/unit_draw.h"

namespace b4p {

/// Draws by which the instances of a family differ, the same on every platform. With seed 0 nothing is drawn:
/// each answer is the standard one.
class Jitter {
 public:
  explicit Jitter(std::uint64_t seed) : standard_(seed == 0), random_(seed) {}

  bool standard() const { return standard_; }

  /// Uniform in [0, 1).
  double unit() { return unitDraw(random_); }

  /// `value`, moved by up to `most_m` and then a whole number of millimetres.
  double around(double value, double most_m) {
    constexpr double kPerMetre = 1000.0;
    if (standard_) return value;
    return value + std::round((2.0 * unit() - 1.0) * most_m * kPerMetre) / kPerMetre;
  }

  bool coin() { return !standard_ && unit() < 0.5; }

 private:
  bool standard_;
  std::mt19937_64 random_;
};

}  // namespace b4p
