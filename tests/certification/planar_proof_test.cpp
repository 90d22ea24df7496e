// SPDX-License-Identifier: BSD-3-Clause
// What can pass is never called blocked; what cannot is, once cells are fine enough.
#include "experiments/certification/planar/blocked_proof.h"

#include <gtest/gtest.h>

#include "experiments/certification/planar/shape_slice.h"

namespace b4p::planar {
namespace {

constexpr GridSize kCoarse{0.02, 128}, kFine{0.01, 256};

bool never() { return false; }

Polygon rectangle(double x1, double y1, double x2, double y2) {
  return {{x1, y1}, {x2, y1}, {x2, y2}, {x1, y2}};
}

bool provedBlocked(const PlanarTask& task, const GridSize& grid) {
  return floodFromStart(task, grid, never)->blocked;
}

/// A body of 0.4 m x 0.2 m before a slot, 1 m long, along x.
PlanarTask slot(double width_m) {
  PlanarTask task;
  task.slices = {{{rectangle(-0.2, -0.1, 0.2, 0.1)},
                  {rectangle(2, -3, 3, -width_m / 2), rectangle(2, width_m / 2, 3, 3)}}};
  task.min_m = {0, -2};
  task.max_m = {5, 2};
  task.start = {{1, 0.4}, 1.0};
  task.point_m = {0, 0};
  task.goal_min_m = {3.9, -0.1};
  task.goal_max_m = {4.1, 0.1};
  return task;
}

TEST(Slot, WiderThanTheBodyIsNeverCalledBlocked) {
  for (const GridSize& grid : {kCoarse, kFine, GridSize{0.1, 16}}) {
    EXPECT_FALSE(provedBlocked(slot(0.201), grid));
    EXPECT_FALSE(provedBlocked(slot(0.5), grid));
  }
}

TEST(Slot, NarrowerThanTheBodyIsProvedBlocked) {
  EXPECT_TRUE(provedBlocked(slot(0.16), kCoarse));
  EXPECT_TRUE(provedBlocked(slot(0.18), kFine));
}

TEST(Slot, FinerCellsProveWhatCoarserOnesCannot) {
  EXPECT_FALSE(provedBlocked(slot(0.19), kCoarse));
  EXPECT_TRUE(provedBlocked(slot(0.19), {0.005, 512}));
}

TEST(Slot, WindowOfTheGoalAngleCounts) {
  // Behind a slot in which the body cannot turn there is no room to turn either.
  PlanarTask task = slot(0.25);
  task.slices[0].fixed.push_back(rectangle(3, -3, 5, -0.13));
  task.slices[0].fixed.push_back(rectangle(3, 0.13, 5, 3));
  EXPECT_FALSE(provedBlocked(task, kCoarse));
  task.goal_angle_rad = 1.5;
  task.goal_half_angle_rad = 0.1;
  EXPECT_TRUE(provedBlocked(task, kCoarse));
  task.goal_angle_rad = kPi;
  EXPECT_FALSE(provedBlocked(task, kCoarse)) << "it can go in backwards";
}

/// A corridor along x that meets one along y, both 0.5 m wide, and a body of this length and 0.1 m width. In
/// each corridor for itself the body has room.
PlanarTask bend(double length_m) {
  PlanarTask task;
  task.slices = {{{rectangle(-length_m / 2, -0.05, length_m / 2, 0.05)},
                  {rectangle(-5, -1, 1.5, 0), rectangle(0.5, -1, 1.5, 5), rectangle(-5, 0.5, 0, 5)}}};
  task.min_m = {-3, 0};
  task.max_m = {0.5, 4};
  task.start = {{-2, 0.25}, 0.0};
  task.point_m = {0, 0};
  task.goal_min_m = {0.2, 2.9};
  task.goal_max_m = {0.3, 3.1};
  return task;
}

TEST(Bend, BlocksTheBodyThatIsTooLongToTurn) {
  EXPECT_TRUE(provedBlocked(bend(1.8), kCoarse));
  PlanarTask straight_on = bend(1.8);
  straight_on.goal_min_m = {-1.1, 0.2};
  straight_on.goal_max_m = {-1.0, 0.3};
  EXPECT_FALSE(provedBlocked(straight_on, kCoarse));
}

TEST(Bend, LetsTheShortBodyThrough) {
  EXPECT_FALSE(provedBlocked(bend(0.9), kCoarse));
  EXPECT_FALSE(provedBlocked(bend(0.9), kFine));
}

TEST(FloodFromStart, BeginsOnTheBoundaryOfCellsToo) {
  PlanarTask task = slot(0.5);
  for (const double h : {0.01, 0.02, 0.05, 0.1})
    for (int i = 0; i < 20; ++i) {
      const Se2Grid grid = gridOf(task, {h, 32});
      task.start = {{grid.min_m.x() + (5 + i / 2) * h, grid.min_m.y() + (20 - i / 2) * h + 1.0},
                    grid.layerAngle() * (i + 0.5)};
      EXPECT_GT(floodFromStart(task, {h, 32}, never)->reached_cells, 0u) << h << " " << i;
    }
}

TEST(FloodFromStart, GivesNoAnswerWhenStopped) {
  EXPECT_FALSE(floodFromStart(slot(0.3), kCoarse, [] { return true; }).has_value());
}

TEST(ShapeSlice, CutsAreInsideRoundShapesAndExactForBoxes) {
  const Polygon box = cutAt(innerPoints(Box{{0.4, 0.2, 0.1}}), 0.03);
  EXPECT_EQ(box.size(), 4u);
  for (const Eigen::Vector2d& corner : box)
    EXPECT_TRUE(corner.cwiseAbs().isApprox(Eigen::Vector2d(0.2, 0.1), 1e-12));
  for (const auto& [shape, radius] : std::vector<std::pair<Shape, double>>{
           {Cylinder{0.5, 1.0}, 0.5}, {Sphere{0.5}, 0.4}, {Capsule{0.5, 0.0}, 0.4}}) {
    const Polygon cut = cutAt(innerPoints(shape), 0.3);
    ASSERT_GE(cut.size(), 16u);
    EXPECT_LE(farthestCorner(cut), radius + 1e-12);
    EXPECT_GT(farthestCorner(cut), 0.95 * radius);
  }
  EXPECT_LT(cutAt(innerPoints(Sphere{0.5}), 0.6).size(), 3u);
}

}  // namespace
}  // namespace b4p::planar
