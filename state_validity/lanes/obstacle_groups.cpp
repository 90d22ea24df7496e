// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/lanes/obstacle_groups.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "state_validity/lanes/lane_world.h"

namespace b4p::lanes {
namespace {

constexpr float kNowhere = std::numeric_limits<float>::infinity();

using Place = std::vector<int>::iterator;

/// Halves first ... last across their longer extent until groups are left.
void sortTogether(const LaneBoxes& boxes, Place first, Place last) {
  const std::ptrdiff_t count = last - first;
  if (count <= kLanes) return;
  int widest = 0;
  float widest_m = -1.0f;
  const auto twiceMiddle = [&boxes](int axis, int box) {
    return boxes.low[axis][static_cast<std::size_t>(box)] + boxes.high[axis][static_cast<std::size_t>(box)];
  };
  for (int axis = 0; axis < 3; ++axis) {
    const auto [least, most] = std::minmax_element(
        first, last, [&](int a, int b) { return twiceMiddle(axis, a) < twiceMiddle(axis, b); });
    const float extent_m = twiceMiddle(axis, *most) - twiceMiddle(axis, *least);
    if (extent_m <= widest_m) continue;
    widest = axis;
    widest_m = extent_m;
  }
  const Place middle = first + (count / 2 + kLanes - 1) / kLanes * kLanes;
  std::nth_element(first, middle, last,
                   [&](int a, int b) { return twiceMiddle(widest, a) < twiceMiddle(widest, b); });
  sortTogether(boxes, first, middle);
  sortTogether(boxes, middle, last);
}

}  // namespace

ObstacleGroups groupObstacles(const LaneBoxes& boxes) {
  ObstacleGroups sorted;
  const std::size_t lanes = static_cast<std::size_t>(kLanes), count = boxes.low[0].size(),
                    groups = (count + lanes - 1) / lanes;
  sorted.count = static_cast<int>(groups);
  sorted.order.resize(count);
  std::iota(sorted.order.begin(), sorted.order.end(), 0);
  sortTogether(boxes, sorted.order.begin(), sorted.order.end());
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<float>&low = sorted.boxes.low[axis], &high = sorted.boxes.high[axis];
    low.assign(groups * lanes, kNowhere);
    high.assign(groups * lanes, -kNowhere);
    sorted.groups.low[axis].assign(groups + lanes, kNowhere);
    sorted.groups.high[axis].assign(groups + lanes, -kNowhere);
    for (std::size_t place = 0; place < count; ++place) {
      const auto box = static_cast<std::size_t>(sorted.order[place]);
      low[place] = boxes.low[axis][box];
      high[place] = boxes.high[axis][box];
      float &group_low = sorted.groups.low[axis][place / lanes],
            &group_high = sorted.groups.high[axis][place / lanes];
      group_low = std::min(group_low, low[place]);
      group_high = std::max(group_high, high[place]);
    }
  }
  sorted.order.resize(groups * lanes, -1);
  return sorted;
}

}  // namespace b4p::lanes
