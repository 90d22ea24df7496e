// SPDX-License-Identifier: BSD-3-Clause
// The parts of the flood fill: bits, runs, polygons, and a fill that agrees with the simplest one.
#include "experiments/certification/planar/flood_fill.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include "experiments/certification/planar/convex_polygon.h"
#include "experiments/certification/planar/se2_grid.h"

namespace b4p::planar {
namespace {

bool never() { return false; }

TEST(BitVolume, RunsEndWhereTheyShould) {
  constexpr int kColumns = 150;
  for (const auto& [first, last] : std::vector<std::pair<int, int>>{
           {0, 0}, {63, 63}, {63, 64}, {64, 127}, {5, 149}, {0, 149}, {149, 149}, {7, 6}}) {
    BitVolume bits(2, 3, kColumns);
    bits.setRun(1, 2, first, last);
    for (int column = 0; column < kColumns; ++column) {
      const bool inside = column >= first && column <= last;
      EXPECT_EQ(bits.test(1, 2, column), inside) << first << " " << last << " " << column;
      EXPECT_EQ(bits.anyInRun(1, 2, column, column), inside);
    }
    EXPECT_EQ(bits.count(), static_cast<std::uint64_t>(last - first + 1));
    EXPECT_EQ(bits.anyInRun(1, 2, 0, kColumns - 1), last >= first);
  }
}

TEST(Grid, CoversItsRectangleAndFindsCellsByTheirCentres) {
  const Se2Grid grid({-1.0, 2.0}, {0.05, 2.5}, 0.1, 8);
  EXPECT_GE(grid.min_m.x() + grid.columns * grid.cell_m, 0.05);
  EXPECT_GE(grid.min_m.y() + grid.rows * grid.cell_m, 2.5);
  const Se2Grid::Range columns = grid.columnsWithin(-0.96, -0.64);
  EXPECT_EQ(columns.first, 0);
  EXPECT_EQ(columns.last, 3);
  const Se2Grid::Range outside = grid.rowsWithin(5.0, 6.0);
  EXPECT_GT(outside.first, outside.last);
  const Se2Grid::Range all = grid.rowsWithin(-1e9, 1e9);
  EXPECT_EQ(all.first, 0);
  EXPECT_EQ(all.last, grid.rows - 1);
}

TEST(ConvexPolygon, HullLeavesOutWhatLiesInside) {
  const Polygon hull = convexHull({{0, 0}, {2, 0}, {1, 0}, {1, 1}, {2, 2}, {0, 2}, {0, 0}});
  const Polygon square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  EXPECT_EQ(hull, square);
}

TEST(ConvexPolygon, OverlapPositionsAreThoseAtWhichTheTwoOverlap) {
  const Polygon fixed{{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  const Polygon moving{{-0.5, -0.25}, {0.5, -0.25}, {0.5, 0.25}, {-0.5, 0.25}};
  const Polygon expected{{-0.5, -0.25}, {2.5, -0.25}, {2.5, 1.25}, {-0.5, 1.25}};
  EXPECT_EQ(overlapPositions(fixed, moving), expected);
}

TEST(ConvexPolygon, ErodedBySquareAndDisc) {
  for (const HalfPlane& side : eroded({{0, 0}, {2, 0}, {2, 1}, {0, 1}}, 0.1, 0.05))
    EXPECT_NEAR(side.normal.dot(Eigen::Vector2d(1.0, 0.5)) - side.offset,
                -(std::abs(side.normal.x()) > 0.5 ? 1.0 : 0.5) + 0.15, 1e-12);
  const auto slanted = eroded({{0, 0}, {1, 0}, {0, 1}}, 0.1, 0.0)[1];
  EXPECT_NEAR(slanted.offset, std::sqrt(0.5) - 0.1 * std::sqrt(2.0), 1e-12) << "the square's corner counts";
}

/// The fill written down as its definition.
BitVolume simplestFill(const BitVolume& blocked, const BitVolume& seeds) {
  BitVolume reached(blocked.layers(), blocked.rows(), blocked.columns());
  std::vector<std::array<int, 3>> list;
  const auto reach = [&](int layer, int row, int column) {
    if (row < 0 || row >= blocked.rows() || column < 0 || column >= blocked.columns()) return;
    layer = (layer + blocked.layers()) % blocked.layers();
    if (blocked.test(layer, row, column) || reached.test(layer, row, column)) return;
    reached.setRun(layer, row, column, column);
    list.push_back({layer, row, column});
  };
  for (int layer = 0; layer < blocked.layers(); ++layer)
    for (int row = 0; row < blocked.rows(); ++row)
      for (int column = 0; column < blocked.columns(); ++column)
        if (seeds.test(layer, row, column)) reach(layer, row, column);
  while (!list.empty()) {
    const auto [layer, row, column] = list.back();
    list.pop_back();
    for (int l = -1; l <= 1; ++l)
      for (int r = -1; r <= 1; ++r)
        for (int c = -1; c <= 1; ++c) reach(layer + l, row + r, column + c);
  }
  return reached;
}

TEST(FloodFill, AgreesWithTheSimplestFillOnRandomCells) {
  std::mt19937_64 random(1);
  int partly = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const int columns = std::uniform_int_distribution<int>(1, 200)(random);
    const double share = std::uniform_real_distribution<double>(0.75, 0.95)(random);
    BitVolume blocked(6, 11, columns), seeds(6, 11, columns);
    for (int layer = 0; layer < 6; ++layer)
      for (int row = 0; row < 11; ++row)
        for (int column = 0; column < columns; ++column) {
          if (std::bernoulli_distribution(share)(random)) blocked.setRun(layer, row, column, column);
          if (std::bernoulli_distribution(0.003)(random)) seeds.setRun(layer, row, column, column);
        }
    const BitVolume expected = simplestFill(blocked, seeds);
    ASSERT_TRUE(floodFill(blocked, seeds, never));
    for (int layer = 0; layer < 6; ++layer)
      for (int row = 0; row < 11; ++row)
        for (int column = 0; column < columns; ++column)
          ASSERT_EQ(seeds.test(layer, row, column), expected.test(layer, row, column)) << trial;
    const std::uint64_t free = 6u * 11u * static_cast<unsigned>(columns) - blocked.count();
    if (expected.count() > 0 && expected.count() < free) ++partly;
  }
  EXPECT_GT(partly, 20) << "the trials say little";
}

TEST(FloodFill, EndsWhenToldTo) {
  BitVolume blocked(2, 2, 2), reached(2, 2, 2);
  reached.setRun(0, 0, 0, 0);
  EXPECT_FALSE(floodFill(blocked, reached, [] { return true; }));
}

}  // namespace
}  // namespace b4p::planar
