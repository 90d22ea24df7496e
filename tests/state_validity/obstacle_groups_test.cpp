// SPDX-License-Identifier: BSD-3-Clause
// Each box has one place, each group holds its boxes, and places without a box meet nothing.
#include "state_validity/lanes/obstacle_groups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "state_validity/lanes/lane_world.h"

namespace b4p::lanes {
namespace {

LaneBoxes randomBoxes(std::size_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> middle(-5.0f, 5.0f), half(0.0f, 0.3f);
  LaneBoxes boxes;
  for (std::size_t i = 0; i < count; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      const float at = middle(random), size = half(random);
      boxes.low[axis].push_back(at - size);
      boxes.high[axis].push_back(at + size);
    }
  return boxes;
}

TEST(ObstacleGroups, HoldEachBoxOnce) {
  for (const std::size_t count : {0u, 1u, 15u, 16u, 17u, 33u, 1000u}) {
    const LaneBoxes boxes = randomBoxes(count);
    const ObstacleGroups sorted = groupObstacles(boxes);
    const auto lanes = static_cast<std::size_t>(kLanes),
               places = static_cast<std::size_t>(sorted.count) * lanes;
    EXPECT_EQ(static_cast<std::size_t>(sorted.count), (count + lanes - 1) / lanes);
    ASSERT_EQ(sorted.order.size(), places);
    std::vector<int> seen(count, 0);
    for (std::size_t place = 0; place < places; ++place) {
      const int box = sorted.order[place];
      for (int axis = 0; axis < 3; ++axis) {
        const float low = sorted.boxes.low[axis][place], high = sorted.boxes.high[axis][place];
        if (box < 0) {
          EXPECT_GT(low, high);
          continue;
        }
        EXPECT_EQ(low, boxes.low[axis][static_cast<std::size_t>(box)]);
        EXPECT_EQ(high, boxes.high[axis][static_cast<std::size_t>(box)]);
        EXPECT_LE(sorted.groups.low[axis][place / lanes], low);
        EXPECT_GE(sorted.groups.high[axis][place / lanes], high);
      }
      if (box >= 0) ++seen[static_cast<std::size_t>(box)];
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(count)) << count;
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_GE(sorted.groups.low[axis].size(), static_cast<std::size_t>(sorted.count) + lanes);
  }
}

TEST(ObstacleGroups, LieTogether) {
  const ObstacleGroups sorted = groupObstacles(randomBoxes(4096));
  double volume = 0.0;
  for (std::size_t group = 0; group < static_cast<std::size_t>(sorted.count); ++group) {
    double extent = 1.0;
    for (int axis = 0; axis < 3; ++axis)
      extent *= sorted.groups.high[axis][group] - sorted.groups.low[axis][group];
    volume += extent;
  }
  // 256 groups that share the 1000 cubic metres fairly, a little larger for their boxes' sizes; in any order
  // each would have most of it.
  EXPECT_LT(volume, 3.0 * 1000.0);
}

}  // namespace
}  // namespace b4p::lanes
