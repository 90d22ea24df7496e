// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "experiments/placement/distance_field.h"

namespace b4p {

enum class BoundSide { kAbove, kBelow };

/// A bound of an object's clearance, in a small part of the time that the clearance takes: points of the
/// object that are close together are taken as one, with the extreme of the distance field around it.
/// Immutable.
class ClearanceBound {
 public:
  /// @param points_O  points of the object, in its frame; at least one
  ClearanceBound(const DistanceField& field, const std::vector<Eigen::Vector3d>& points_O, BoundSide side);

  /// A number that the mean of the field over the points is not above (or not below) when O is at X_WO.
  double at(const Eigen::Isometry3d& X_WO) const;

 private:
  struct Cluster {
    Eigen::Vector3d p_O;
    double share;  ///< of all points
  };

  Lattice lattice_;
  std::vector<Cluster> clusters_;
  std::vector<float> extremes_m_;  ///< of the field over the cells that a cluster's points may touch
};

}  // namespace b4p
