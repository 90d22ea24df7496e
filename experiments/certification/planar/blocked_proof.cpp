// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/certification/planar/blocked_proof.h"

#include <cmath>

#include <Eigen/Geometry>

#include "experiments/certification/planar/flood_fill.h"

namespace b4p::planar {
namespace {

/// So that what lies on the boundary between two cells is in one of them, whatever rounding does.
constexpr double kRounding = 1e-6;  // m or rad

/// Whether some angle of a layer lies in a window.
bool layerMeets(const Se2Grid& grid, int layer, double middle_rad, double half_rad) {
  const double off = std::abs(std::remainder(grid.angleOf(layer) - middle_rad, 2.0 * kPi));
  return off <= half_rad + grid.layerAngle() / 2.0 + kRounding;
}

/// A rectangle of cells in one layer.
struct Patch {
  Se2Grid::Range rows, columns;
};

/// Cells that come nearer than `margin_m` (in x and y) to the rectangle [low, high].
Patch patchNear(const Se2Grid& grid, const Eigen::Vector2d& low, const Eigen::Vector2d& high,
                double margin_m) {
  const double reach = margin_m + grid.cell_m / 2.0 + kRounding;
  return {grid.rowsWithin(low.y() - reach, high.y() + reach),
          grid.columnsWithin(low.x() - reach, high.x() + reach)};
}

void markStart(const PlanarTask& task, const Se2Grid& grid, BitVolume& reached) {
  const Patch patch = patchNear(grid, task.start.position, task.start.position, task.tolerance_m);
  for (int layer = 0; layer < grid.layers; ++layer) {
    if (!layerMeets(grid, layer, task.start.angle_rad, task.tolerance_rad)) continue;
    for (int row = patch.rows.first; row <= patch.rows.last; ++row)
      reached.setRun(layer, row, patch.columns.first, patch.columns.last);
  }
}

bool reachesGoal(const PlanarTask& task, const Se2Grid& grid, const BitVolume& reached) {
  // Turned by half a layer, the point travels no farther than this.
  const double turn_m = task.point_m.norm() * grid.layerAngle() / 2.0;
  for (int layer = 0; layer < grid.layers; ++layer) {
    if (!layerMeets(grid, layer, task.goal_angle_rad, task.goal_half_angle_rad + task.tolerance_rad))
      continue;
    const Eigen::Vector2d point = Eigen::Rotation2Dd(grid.angleOf(layer)) * task.point_m;
    const Patch patch =
        patchNear(grid, task.goal_min_m - point, task.goal_max_m - point, task.tolerance_m + turn_m);
    for (int row = patch.rows.first; row <= patch.rows.last; ++row)
      if (reached.anyInRun(layer, row, patch.columns.first, patch.columns.last)) return true;
  }
  return false;
}

}  // namespace

Se2Grid gridOf(const PlanarTask& task, const GridSize& size) {
  return Se2Grid(task.min_m, task.max_m, size.cell_m, size.angles);
}

std::optional<BitVolume> blockedCells(const PlanarTask& task, const Se2Grid& grid,
                                      const std::function<bool()>& stop) {
  BitVolume blocked(grid.layers, grid.rows, grid.columns);
  for (int layer = 0; layer < grid.layers; ++layer) {
    if (stop()) return std::nullopt;
    for (const Slice& slice : task.slices) markBlocked(slice, grid, layer, blocked);
  }
  return blocked;
}

std::optional<FillOutcome> floodFromStart(const PlanarTask& task, const GridSize& size,
                                          const std::function<bool()>& stop) {
  const Se2Grid grid = gridOf(task, size);
  const std::optional<BitVolume> blocked = blockedCells(task, grid, stop);
  if (!blocked) return std::nullopt;
  BitVolume reached(grid.layers, grid.rows, grid.columns);
  markStart(task, grid, reached);
  if (!floodFill(*blocked, reached, stop)) return std::nullopt;
  return FillOutcome{!reachesGoal(task, grid, reached), blocked->count(), reached.count()};
}

}  // namespace b4p::planar
