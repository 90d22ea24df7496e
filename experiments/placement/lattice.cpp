// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/lattice.h"

namespace b4p {
namespace {

constexpr double kRounding = 1e-6;  ///< of a cell: sizes that are multiples of the cell but for rounding

}  // namespace

Lattice latticeInside(const Eigen::Vector3d& low_m, const Eigen::Vector3d& high_m, double cell_m) {
  Lattice lattice;
  lattice.origin_m = low_m;
  lattice.cell_m = cell_m;
  lattice.count = ((high_m - low_m) / cell_m).array().operator+(kRounding).floor().cast<int>().matrix();
  return lattice;
}

Lattice latticeAround(const Eigen::Vector3d& low_m, const Eigen::Vector3d& high_m, double cell_m) {
  Lattice lattice;
  lattice.cell_m = cell_m;
  lattice.count = ((high_m - low_m) / cell_m).array().operator-(kRounding).ceil().cast<int>().matrix();
  lattice.count = lattice.count.cwiseMax(1);
  lattice.origin_m = (low_m + high_m) / 2.0 - cell_m / 2.0 * lattice.count.cast<double>();
  return lattice;
}

}  // namespace b4p
