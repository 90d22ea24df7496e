// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include "experiments/scene.h"

namespace b4p {

/// Draws object poses in a placement region and says how far others are from it. Immutable.
class PlacementSampler {
 public:
  /// @param margin_m, upright_tolerance_rad  how well drawn poses are reached. Positions nearer to the
  /// region's boundary than
  ///   the margin are not drawn (sides shorter than twice the margin: at their middle), and what lies outside
  ///   by less, or is tilted by less, is inside.
  PlacementSampler(const PlacementSource& source, const Eigen::Isometry3d& X_WO_start, double margin_m,
                   double upright_tolerance_rad);

  /// Position and yaw uniform in their windows.
  Eigen::Isometry3d sample(std::mt19937_64& random) const;

  /// Distance of the object's origin from the region beyond the margin (m), plus, when the object has to
  /// stand upright, the tilt of its z axis beyond the tolerance (rad).
  double distance(const Eigen::Isometry3d& X_WO) const;

 private:
  PlacementSource source_;
  double margin_m_;
  double upright_tolerance_rad_;
  Eigen::Vector3d low_, high_;  ///< box of positions drawn
  Eigen::Matrix3d R_WO_;        ///< orientation at yaw 0
};

}  // namespace b4p
