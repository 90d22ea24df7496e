// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace b4p {

/// The configurations at which a straight joint edge is checked: fractions k / last() for k = 0 .. last(), so
/// that the edge walked backwards meets the same configurations. Keeps pointers to both ends.
class EdgeSamples {
 public:
  /// @param swept_m  bound (m) of how far any point travels along the edge; between neighbours it is at most
  /// step_m
  /// @throws std::invalid_argument for an edge of more than a thousand million samples
  EdgeSamples(const double* q1, const double* q2, int dof, double swept_m, double step_m)
      : q1_(q1), q2_(q2), dof_(dof), last_(intervals(swept_m, step_m)) {}

  std::int64_t last() const { return last_; }
  const double* q1() const { return q1_; }
  const double* q2() const { return q2_; }

  /// The k-th configuration; q1 and q2 themselves at the ends.
  void at(std::int64_t k, double* q) const {
    const double towards_q2 = static_cast<double>(k) / static_cast<double>(last_);
    const double towards_q1 = static_cast<double>(last_ - k) / static_cast<double>(last_);
    if (k == 0 || k == last_) {
      std::copy_n(k == 0 ? q1_ : q2_, dof_, q);
    } else {
      for (int i = 0; i < dof_; ++i) q[i] = towards_q1 * q1_[i] + towards_q2 * q2_[i];
    }
  }

 private:
  // Rounding must not add a sample to an edge that is a whole number of steps long: a part of a free edge,
  // cut at a sample, is then checked at the same configurations again.
  static std::int64_t intervals(double swept_m, double step_m) {
    constexpr double kRounding = 1e-9;
    constexpr double kMostIntervals = 1e9;
    const double count = std::ceil(swept_m / step_m * (1.0 - kRounding));
    if (!(count <= kMostIntervals)) throw std::invalid_argument("an edge has too many samples to be checked");
    return std::max<std::int64_t>(1, static_cast<std::int64_t>(count));
  }

  const double* q1_;
  const double* q2_;
  int dof_;
  std::int64_t last_;
};

}  // namespace b4p
