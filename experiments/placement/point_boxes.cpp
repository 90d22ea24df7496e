// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/point_boxes.h"

#include <set>
#include <tuple>

#include "robots/input_error.h"

namespace b4p {

std::vector<Obstacle> boxesAround(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& origin_m,
                                  double cell_m, const std::string& name) {
  constexpr std::size_t kMostBoxes = 20000;
  // Cells in order of z, y, x.
  std::set<std::tuple<int, int, int>> cells;
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector3i cell = ((p - origin_m) / cell_m).array().floor().cast<int>().matrix();
    cells.emplace(cell.z(), cell.y(), cell.x());
  }
  std::vector<Obstacle> boxes;
  while (!cells.empty()) {
    const auto [z, y, x] = *cells.begin();
    int wide = 1, deep = 1, high = 1;
    while (cells.count({z, y, x + wide}) > 0) ++wide;
    const auto full = [&, z0 = z, y0 = y, x0 = x](int z_at, int y_at) {
      for (int i = 0; i < wide; ++i)
        if (cells.count({z0 + z_at, y0 + y_at, x0 + i}) == 0) return false;
      return true;
    };
    while (full(0, deep)) ++deep;
    const auto fullLayer = [&](int z_at) {
      for (int j = 0; j < deep; ++j)
        if (!full(z_at, j)) return false;
      return true;
    };
    while (fullLayer(high)) ++high;
    const int z0 = z, y0 = y, x0 = x;  // the entry they refer to goes
    for (int k = 0; k < high; ++k)
      for (int j = 0; j < deep; ++j)
        for (int i = 0; i < wide; ++i) cells.erase({z0 + k, y0 + j, x0 + i});
    const Eigen::Vector3d size = cell_m * Eigen::Vector3d(wide, deep, high);
    Obstacle box{name + "_" + std::to_string(boxes.size()), {Box{size}, Eigen::Isometry3d::Identity()}};
    box.shape.X_BS.translation() = origin_m + cell_m * Eigen::Vector3d(x0, y0, z0) + size / 2.0;
    boxes.push_back(std::move(box));
    if (boxes.size() > kMostBoxes)
      throw InputError(name, "", "fills too many cells that make no larger boxes");
  }
  return boxes;
}

}  // namespace b4p
