// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/certification/planar/obstacle_raster.h"

#include <algorithm>
#include <limits>

namespace b4p::planar {
namespace {

constexpr double kRounding_m = 1e-5;

/// The x for which (x, y) lies in all half-planes: from low to high, low > high for none.
struct Interval {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

Interval atHeight(const std::vector<HalfPlane>& half_planes, double y) {
  constexpr double kLevel = 1e-12;
  Interval x;
  for (const HalfPlane& h : half_planes) {
    const double rest = h.offset - h.normal.y() * y;
    if (h.normal.x() > kLevel)
      x.high = std::min(x.high, rest / h.normal.x());
    else if (h.normal.x() < -kLevel)
      x.low = std::max(x.low, rest / h.normal.x());
    else if (rest < 0.0)
      return {0.0, -1.0};
  }
  return x;
}

void markPolygon(const Polygon& polygon, double turn_m, const Se2Grid& grid, int layer, BitVolume& blocked) {
  const std::vector<HalfPlane> inside = eroded(polygon, grid.cell_m / 2.0, turn_m + kRounding_m);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Eigen::Vector2d& corner : polygon) {
    low = std::min(low, corner.y());
    high = std::max(high, corner.y());
  }
  const Se2Grid::Range rows = grid.rowsWithin(low, high);
  for (int row = rows.first; row <= rows.last; ++row) {
    const Interval x = atHeight(inside, grid.yOf(row));
    if (x.low > x.high) continue;
    const Se2Grid::Range columns = grid.columnsWithin(x.low, x.high);
    blocked.setRun(layer, row, columns.first, columns.last);
  }
}

}  // namespace

void markBlocked(const Slice& slice, const Se2Grid& grid, int layer, BitVolume& blocked) {
  for (const Polygon& piece : slice.moving) {
    const Polygon moving = turned(piece, grid.angleOf(layer));
    const double turn_m = farthestCorner(piece) * grid.layerAngle() / 2.0;
    for (const Polygon& fixed : slice.fixed)
      markPolygon(overlapPositions(fixed, moving), turn_m, grid, layer, blocked);
  }
}

}  // namespace b4p::planar
