// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "robots/manipulator.h"

namespace b4p {

/// The limits of a robot's planned joints, revolute ones up to whole turns. Immutable, shared by all threads.
class JointLimits {
 public:
  explicit JointLimits(const Manipulator& robot);

  /// Brings a value of joint i as far inside its limits as whole turns can, and the rest of the way by
  /// clamping. NaN stays NaN.
  double bringInside(int i, double value) const {
    const Limit& limit = limits_[static_cast<std::size_t>(i)];
    if (value >= limit.lower && value <= limit.upper) return value;
    return std::clamp(limit.revolute ? turned(limit, value) : value, limit.lower, limit.upper);
  }

  /// True when joint i rests on the limit that a motion in the given direction would cross.
  bool blocks(int i, double value, double direction) const {
    const Limit& limit = limits_[static_cast<std::size_t>(i)];
    return (value >= limit.upper && direction > 0.0) || (value <= limit.lower && direction < 0.0);
  }

 private:
  struct Limit {
    double lower, upper;
    bool revolute;
  };

  /// By whole turns as near to the limits as possible.
  static double turned(const Limit& limit, double value);

  std::vector<Limit> limits_;
};

}  // namespace b4p
