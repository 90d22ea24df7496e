// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/occupancy_grid.h"

#include <algorithm>

#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision.h>

#include "experiments/placement/solid.h"
#include "state_validity/fcl_shapes.h"
#include "state_validity/shape_bounds.h"

namespace b4p {
namespace {

constexpr double kTouch_m = 1e-6;

/// A convex shape against blocks of cells.
class BlockTest {
 public:
  BlockTest(const Lattice& lattice, const PlacedShape& placed)
      : lattice_(lattice), placed_(placed), X_SB_(placed.X_BS.inverse()), shape_(fclShape(placed.shape)) {}

  Eigen::Vector3d low(const Eigen::Vector3i& first) const {
    return lattice_.origin_m + lattice_.cell_m * first.cast<double>();
  }

  bool overlaps(const Eigen::Vector3i& first, const Eigen::Vector3i& beyond) const {
    const Eigen::Vector3d from = low(first), to = low(beyond);
    const Eigen::Vector3d size = ((to - from).array() - 2.0 * kTouch_m).matrix();
    const fcl::Boxd block(size);
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.translation() = (from + to) / 2.0;
    fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    return fcl::collide(&block, X, shape_.get(), placed_.X_BS, request, result) > 0;
  }

  /// Both are convex, so that the corners decide.
  bool coversAll(const Eigen::Vector3i& first, const Eigen::Vector3i& beyond) const {
    const Eigen::Vector3d from = low(first), to = low(beyond);
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d p((corner & 1) ? from.x() : to.x(), (corner & 2) ? from.y() : to.y(),
                              (corner & 4) ? from.z() : to.z());
      if (!containsPoint(placed_.shape, X_SB_ * p)) return false;
    }
    return true;
  }

 private:
  const Lattice& lattice_;
  const PlacedShape& placed_;
  Eigen::Isometry3d X_SB_;
  FclShape shape_;
};

template <class Occupy>
void fill(const BlockTest& test, const Eigen::Vector3i& first, const Eigen::Vector3i& beyond,
          const Occupy& occupy) {
  if ((first.array() >= beyond.array()).any()) return;
  const Eigen::Vector3i size = beyond - first;
  const bool covered = test.coversAll(first, beyond);
  if (!covered && !test.overlaps(first, beyond)) return;
  if (covered || size.maxCoeff() == 1) {
    for (int z = first.z(); z < beyond.z(); ++z)
      for (int y = first.y(); y < beyond.y(); ++y)
        for (int x = first.x(); x < beyond.x(); ++x) occupy({x, y, z});
    return;
  }
  int axis = 0;
  size.maxCoeff(&axis);
  const int middle = first[axis] + size[axis] / 2;
  Eigen::Vector3i end = beyond, begin = first;
  end[axis] = begin[axis] = middle;
  fill(test, first, end, occupy);
  fill(test, begin, beyond, occupy);
}

}  // namespace

void OccupancyGrid::add(const PlacedShape& placed) {
  const Aabb box = boundsOf(placed.shape).posed(placed.X_BS).aabb();
  // Far coordinates are clamped before they become integers.
  const auto cellsFrom = [&](const Eigen::Vector3d& p) {
    const Eigen::Array3d place = (p - lattice_.origin_m).array() / lattice_.cell_m;
    return place.max(-1.0).min(lattice_.count.cast<double>().array()).floor().cast<int>().matrix().eval();
  };
  const Eigen::Vector3i first = cellsFrom(box.centre - box.half).cwiseMax(0);
  const Eigen::Vector3i beyond =
      (cellsFrom(box.centre + box.half).array() + 1).min(lattice_.count.array()).matrix();
  fill(BlockTest(lattice_, placed), first, beyond, [this](const Eigen::Vector3i& cell) { occupy(cell); });
}

std::vector<Eigen::Vector3d> OccupancyGrid::occupiedCentres() const {
  std::vector<Eigen::Vector3d> centres;
  for (int z = 0; z < lattice_.count.z(); ++z)
    for (int y = 0; y < lattice_.count.y(); ++y)
      for (int x = 0; x < lattice_.count.x(); ++x)
        if (occupied({x, y, z})) centres.push_back(lattice_.centre({x, y, z}));
  return centres;
}

}  // namespace b4p
