// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace b4p::lanes {

/// Axis-aligned boxes by number, side by side.
struct LaneBoxes {
  std::vector<float> low[3], high[3];
};

/// Boxes in groups of kLanes that lie together, so that a query passes over what is far in groups, and over
/// far groups many at a time. Groups are whole: places left over hold boxes that meet nothing.
struct ObstacleGroups {
  std::vector<int> order;  ///< number of the box in each place; -1: none
  LaneBoxes boxes;         ///< by place
  LaneBoxes
      groups;     ///< around places g kLanes ... (g + 1) kLanes - 1, with room for whole registers at the end
  int count = 0;  ///< of groups
};

/// @param boxes  any number of them
ObstacleGroups groupObstacles(const LaneBoxes& boxes);

}  // namespace b4p::lanes
