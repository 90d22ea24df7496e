// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include <Eigen/Core>

namespace b4p::planar {

constexpr double kPi = 3.14159265358979323846;

/// Pose of a body in the plane: position of its origin (m) and angle (rad).
struct Pose {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  double angle_rad = 0.0;
};

/// Cuts the poses with positions in a rectangle into closed cells: squares of `cell_m` times equal parts of
/// the full turn. Cell (layer, row, column) has its centre at angleOf(layer), yOf(row), xOf(column); layers
/// wrap around.
struct Se2Grid {
  Eigen::Vector2d min_m;
  double cell_m;
  int columns, rows, layers;

  /// The coarsest such grid that covers all of [min_m, max_m].
  Se2Grid(const Eigen::Vector2d& min, const Eigen::Vector2d& max, double cell, int angles)
      : min_m(min),
        cell_m(cell),
        columns(static_cast<int>(std::floor((max.x() - min.x()) / cell)) + 1),
        rows(static_cast<int>(std::floor((max.y() - min.y()) / cell)) + 1),
        layers(angles) {}

  double xOf(int column) const { return min_m.x() + (column + 0.5) * cell_m; }
  double yOf(int row) const { return min_m.y() + (row + 0.5) * cell_m; }
  double angleOf(int layer) const { return layer * layerAngle(); }
  double layerAngle() const { return 2.0 * kPi / layers; }

  /// Columns (or rows) whose centre's coordinate lies in [low, high]: first and last, first > last for none.
  struct Range {
    int first, last;
  };
  Range columnsWithin(double low, double high) const { return within(low, high, min_m.x(), columns); }
  Range rowsWithin(double low, double high) const { return within(low, high, min_m.y(), rows); }

  double cells() const { return static_cast<double>(columns) * rows * layers; }

 private:
  Range within(double low, double high, double origin, int count) const {
    const double first = std::ceil((low - origin) / cell_m - 0.5);
    const double last = std::floor((high - origin) / cell_m - 0.5);
    return {static_cast<int>(std::fmin(std::fmax(first, 0.0), count)),
            static_cast<int>(std::fmax(std::fmin(last, count - 1.0), -1.0))};
  }
};

}  // namespace b4p::planar
