// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "experiments/placement/occupancy_grid.h"
#include "planners/placement/placement_world.h"

namespace b4p {

/// The horizontal surfaces of an occupancy grid on which things can stand (paper, Section IV-A).
///
/// A surface cell is free, and all nine cells of the 3 x 3 block directly beneath it are occupied. Surface
/// cells of one layer that touch, diagonally as well, form a patch, and patches are cut into tiles of at most
/// `tile_m` a side. Things touch a surface half a cell above the surface cell's bottom.
class ContactSurfaces {
 public:
  explicit ContactSurfaces(const OccupancyGrid& grid, double tile_m = 0.30);

  const std::vector<ContactRegion>& regions() const { return regions_; }

  /// The region of the cell that a point lies in; -1 where that is no surface cell.
  int regionAt(const Eigen::Vector3d& p_W) const;

 private:
  void addPatch(const std::vector<Eigen::Vector3i>& cells, double tile_m);

  Lattice lattice_;
  std::vector<int> region_of_;  ///< per cell; -1: no surface cell
  std::vector<ContactRegion> regions_;
};

}  // namespace b4p
