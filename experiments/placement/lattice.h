// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include <Eigen/Geometry>

namespace b4p {

/// Cubic cells along the axes of some frame.
struct Lattice {
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();  ///< lowest corner of cell (0, 0, 0)
  double cell_m = 0.005;
  Eigen::Vector3i count = Eigen::Vector3i::Zero();

  std::size_t size() const {
    return static_cast<std::size_t>(count.x()) * static_cast<std::size_t>(count.y()) *
           static_cast<std::size_t>(count.z());
  }

  /// Place of a cell in an array; x runs fastest.
  std::size_t index(const Eigen::Vector3i& cell) const {
    return static_cast<std::size_t>(cell.x()) +
           static_cast<std::size_t>(count.x()) *
               (static_cast<std::size_t>(cell.y()) +
                static_cast<std::size_t>(count.y()) * static_cast<std::size_t>(cell.z()));
  }

  bool contains(const Eigen::Vector3i& cell) const {
    return (cell.array() >= 0).all() && (cell.array() < count.array()).all();
  }

  /// The cell that a point lies in; it may be outside. The point is finite and not astronomically far.
  Eigen::Vector3i cellAt(const Eigen::Vector3d& p) const {
    return ((p - origin_m) / cell_m).array().floor().cast<int>().matrix();
  }

  Eigen::Vector3d centre(const Eigen::Vector3i& cell) const {
    return origin_m + cell_m * (cell.cast<double>().array() + 0.5).matrix();
  }
};

/// The largest lattice with its origin at `low_m` that lies inside a box.
Lattice latticeInside(const Eigen::Vector3d& low_m, const Eigen::Vector3d& high_m, double cell_m);

/// The smallest lattice around a box, with the same centre.
Lattice latticeAround(const Eigen::Vector3d& low_m, const Eigen::Vector3d& high_m, double cell_m);

}  // namespace b4p
