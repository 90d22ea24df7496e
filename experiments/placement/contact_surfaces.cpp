// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/contact_surfaces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace b4p {
namespace {

constexpr int kNoSurface = -1, kUnassigned = -2;

bool isSurface(const OccupancyGrid& grid, const Eigen::Vector3i& cell) {
  if (cell.z() == 0 || grid.occupied(cell)) return false;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const Eigen::Vector3i beneath = cell + Eigen::Vector3i(dx, dy, -1);
      if (!grid.lattice().contains(beneath) || !grid.occupied(beneath)) return false;
    }
  return true;
}

}  // namespace

ContactSurfaces::ContactSurfaces(const OccupancyGrid& grid, double tile_m)
    : lattice_(grid.lattice()), region_of_(lattice_.size(), kNoSurface) {
  const Eigen::Vector3i count = lattice_.count;
  const auto forAll = [&](const auto& visit) {
    for (int z = 0; z < count.z(); ++z)
      for (int y = 0; y < count.y(); ++y)
        for (int x = 0; x < count.x(); ++x) visit(Eigen::Vector3i(x, y, z));
  };
  forAll([&](const Eigen::Vector3i& cell) {
    if (isSurface(grid, cell)) region_of_[lattice_.index(cell)] = kUnassigned;
  });
  constexpr int kTaken = -3;
  forAll([&](const Eigen::Vector3i& seed) {
    if (region_of_[lattice_.index(seed)] != kUnassigned) return;
    region_of_[lattice_.index(seed)] = kTaken;
    std::vector<Eigen::Vector3i> patch{seed};
    for (std::size_t i = 0; i < patch.size(); ++i)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const Eigen::Vector3i next = patch[i] + Eigen::Vector3i(dx, dy, 0);
          if (!lattice_.contains(next) || region_of_[lattice_.index(next)] != kUnassigned) continue;
          region_of_[lattice_.index(next)] = kTaken;
          patch.push_back(next);
        }
    addPatch(patch, tile_m);
  });
}

void ContactSurfaces::addPatch(const std::vector<Eigen::Vector3i>& cells, double tile_m) {
  constexpr double kRounding = 1e-6;
  Eigen::Array2i low = cells.front().head<2>(), high = low;
  for (const Eigen::Vector3i& cell : cells) {
    low = low.min(cell.head<2>().array());
    high = high.max(cell.head<2>().array());
  }
  // As few tiles as the size allows, of equal size but for whole cells.
  const Eigen::Array2i size = high - low + 1;
  const double cells_per_tile = std::max(1.0, std::floor(tile_m / lattice_.cell_m + kRounding));
  const Eigen::Array2i tiles = (size.cast<double>() / cells_per_tile).ceil().cast<int>();
  std::map<std::pair<int, int>, int> region_of_tile;
  for (const Eigen::Vector3i& cell : cells) {
    const Eigen::Array2i tile = (cell.head<2>().array() - low) * tiles / size;
    const auto [entry, added] =
        region_of_tile.emplace(std::pair(tile.y(), tile.x()), static_cast<int>(regions_.size()));
    if (added) {
      ContactRegion region;
      region.cell_m = lattice_.cell_m;
      region.height_m = lattice_.centre(cell).z();
      regions_.push_back(std::move(region));
    }
    region_of_[lattice_.index(cell)] = entry->second;
    regions_[static_cast<std::size_t>(entry->second)].cells.emplace_back(lattice_.centre(cell).head<2>());
  }
}

int ContactSurfaces::regionAt(const Eigen::Vector3d& p_W) const {
  const Eigen::Vector3d place = (p_W - lattice_.origin_m) / lattice_.cell_m;
  if (!((place.array() >= 0.0) && (place.array() < lattice_.count.cast<double>().array())).all())
    return kNoSurface;
  return region_of_[lattice_.index(lattice_.cellAt(p_W))];
}

}  // namespace b4p
