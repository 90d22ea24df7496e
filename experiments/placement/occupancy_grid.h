// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "experiments/placement/lattice.h"
#include "robots/shape.h"

namespace b4p {

/// Which cells of a lattice are occupied.
class OccupancyGrid {
 public:
  /// All cells free.
  explicit OccupancyGrid(const Lattice& lattice) : lattice_(lattice), occupied_(lattice.size(), 0) {}

  const Lattice& lattice() const { return lattice_; }

  bool occupied(const Eigen::Vector3i& cell) const { return occupied_[lattice_.index(cell)] != 0; }
  void occupy(const Eigen::Vector3i& cell) { occupied_[lattice_.index(cell)] = 1; }

  /// Occupies all cells that a solid shape overlaps by more than a micrometre, and no other: faces that only
  /// touch a cell do not occupy it.
  /// @param placed  its pose in the lattice's frame
  void add(const PlacedShape& placed);

  std::vector<Eigen::Vector3d> occupiedCentres() const;

 private:
  Lattice lattice_;
  std::vector<char> occupied_;
};

}  // namespace b4p
