// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "experiments/placement/occupancy_grid.h"

namespace b4p {

/// d_S of the paper's Section V: how far a point is from the environment along x, y and positive z. That is
/// the distance (m) to the nearest occupied cell at or above the point's own layer, between centres of cells:
/// what carries an object does not count, neither do the walls of the volume.
///
/// Between centres of cells the values are interpolated linearly; outside the lattice, the nearest value in
/// it holds. Within a layer the value changes by at most |dx| + |dy|, and by at most |(dx, dy)| plus
/// gridError_m(). Where nothing is at or above a layer the value is the lattice's diagonal.
class DistanceField {
 public:
  explicit DistanceField(const OccupancyGrid& grid);

  double at(const Eigen::Vector3d& p_W) const;

  /// Mean over points of a body at X_WP; at least one point.
  double mean(const Eigen::Isometry3d& X_WP, const std::vector<Eigen::Vector3d>& points_P) const;

  /// The distance of a cell's centre.
  double cell(const Eigen::Vector3i& cell) const {
    return static_cast<double>(distance_m_[lattice_.index(cell)]);
  }

  double gridError_m() const;
  const Lattice& lattice() const { return lattice_; }

 private:
  /// At a place in cells from the centre of cell (0, 0, 0).
  double interpolated(double x, double y, double z) const;

  Lattice lattice_;
  std::vector<float> distance_m_;
};

}  // namespace b4p
