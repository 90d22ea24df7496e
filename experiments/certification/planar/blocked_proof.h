// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "experiments/certification/planar/bit_volume.h"
#include "experiments/certification/planar/obstacle_raster.h"
#include "experiments/certification/planar/se2_grid.h"

namespace b4p::planar {

/// A rigid body that slides and turns among fixed obstacles, from a start pose into a region.
struct PlanarTask {
  std::vector<Slice> slices;     ///< the body collides where any slice overlaps
  Eigen::Vector2d min_m, max_m;  ///< positions that the body's origin can take
  Pose start;                    ///< the motion begins within the tolerances of this
  Eigen::Vector2d point_m;       ///< the body's point that has to end in the region, in its own frame
  Eigen::Vector2d goal_min_m, goal_max_m;
  double goal_angle_rad = 0.0;       ///< middle and
  double goal_half_angle_rad = kPi;  ///< half width of the window in which the body's angle ends
  double tolerance_m = 0.0;          ///< start and goal are as much larger in all directions
  double tolerance_rad = 0.0;
};

/// How finely poses are cut into cells.
struct GridSize {
  double cell_m;
  int angles;
};

/// What a flood fill over a grid has found.
struct FillOutcome {
  bool blocked = false;  ///< true: **no** continuous motion leads from start to goal. False: nothing is known
  std::uint64_t blocked_cells = 0;  ///< cells whose every pose collides
  std::uint64_t reached_cells = 0;
};

/// The grid over all positions of a task.
Se2Grid gridOf(const PlanarTask& task, const GridSize& size);

/// All cells that markBlocked() finds; nothing when stopped.
std::optional<BitVolume> blockedCells(const PlanarTask& task, const Se2Grid& grid,
                                      const std::function<bool()>& stop);

/// Floods the cells that are not proved blocked from the start; if no cell that may hold a goal pose is
/// reached, the task has no solution. Memory: two bits a cell.
/// @param stop  asked now and then
/// @return nothing when stopped
std::optional<FillOutcome> floodFromStart(const PlanarTask& task, const GridSize& size,
                                          const std::function<bool()>& stop);

}  // namespace b4p::planar
