// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "experiments/verification/convex_body.h"

namespace b4p::verification {

/// Two bodies no farther apart than this count as touching (m).
constexpr double kTouching_m = 1e-9;

/// How far apart two bodies are, with its proof: along the unit vector `direction` (in W, from b to a) a gap
/// of width `distance_m` lies between them. The number is therefore never too large; where no gap is found it
/// is not positive and says nothing more.
struct Separation {
  double distance_m;
  Eigen::Vector3d direction;

  bool apart() const { return distance_m > kTouching_m; }
};

/// The widest gap that the Gilbert-Johnson-Keerthi iteration finds between a and b: when they are apart,
/// their distance, rarely less by up to 1e-5 m (thin curved bodies; boxes and balls are exact to 1e-7). An
/// iteration that breaks down numerically cannot turn contact into a gap, since only the support functions
/// decide how wide a gap is.
/// @param hint  direction tried first, not zero: best the one of a similar pair of poses
Separation separation(const ConvexBody& a, const Eigen::Isometry3d& X_WA, const ConvexBody& b,
                      const Eigen::Isometry3d& X_WB, const Eigen::Vector3d& hint);

}  // namespace b4p::verification
