// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/clearance_bound.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace b4p {
namespace {

constexpr int kCellsPerCluster = 3;  ///< along each axis
constexpr double kRounding_m = 1e-6;

using Points = std::vector<Eigen::Vector3d>;

/// Points by the cube that they lie in.
std::vector<Points> inCubes(const Points& points, double size_m) {
  std::map<std::tuple<int, int, int>, Points> cubes;
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector3i cube = (p / size_m).array().floor().cast<int>().matrix();
    cubes[{cube.x(), cube.y(), cube.z()}].push_back(p);
  }
  std::vector<Points> list;
  for (auto& [place, inside] : cubes) list.push_back(std::move(inside));
  return list;
}

/// Each value becomes the extreme of those at most `reach` places away along an axis.
void spread(std::vector<float>& values, const Lattice& lattice, int axis, int reach, BoundSide side) {
  const int count = lattice.count[axis];
  const Eigen::Vector3i unit = Eigen::Vector3i::Unit(axis);
  const std::size_t stride = lattice.index(unit);
  std::vector<float> line(static_cast<std::size_t>(count));
  Eigen::Vector3i lines = lattice.count;
  lines[axis] = 1;
  for (int z = 0; z < lines.z(); ++z)
    for (int y = 0; y < lines.y(); ++y)
      for (int x = 0; x < lines.x(); ++x) {
        float* first = values.data() + lattice.index({x, y, z});
        for (std::size_t i = 0; i < line.size(); ++i) line[i] = first[i * stride];
        for (int i = 0; i < count; ++i) {
          const auto begin = line.begin() + std::max(0, i - reach);
          const auto end = line.begin() + std::min(count, i + reach + 1);
          first[static_cast<std::size_t>(i) * stride] =
              side == BoundSide::kAbove ? *std::max_element(begin, end) : *std::min_element(begin, end);
        }
      }
}

}  // namespace

ClearanceBound::ClearanceBound(const DistanceField& field, const Points& points_O, BoundSide side)
    : lattice_(field.lattice()), extremes_m_(field.lattice().size()) {
  double radius_m = 0.0;
  for (const Points& points : inCubes(points_O, kCellsPerCluster * lattice_.cell_m)) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : points) box.extend(p);
    clusters_.push_back(
        {box.center(), static_cast<double>(points.size()) / static_cast<double>(points_O.size())});
    for (const Eigen::Vector3d& p : points) radius_m = std::max(radius_m, (p - box.center()).norm());
  }
  std::size_t i = 0;
  for (int z = 0; z < lattice_.count.z(); ++z)
    for (int y = 0; y < lattice_.count.y(); ++y)
      for (int x = 0; x < lattice_.count.x(); ++x)
        extremes_m_[i++] = static_cast<float>(field.cell({x, y, z}));
  // The field at a point comes from cells whose centres are less than a cell away from it, and the cell that
  // a cluster lies in has its centre within half a cell.
  const int reach = static_cast<int>(std::floor(radius_m / lattice_.cell_m + 1.5));
  for (int axis = 0; axis < 3; ++axis) spread(extremes_m_, lattice_, axis, reach, side);
  const float rounding = static_cast<float>(side == BoundSide::kAbove ? kRounding_m : -kRounding_m);
  for (float& extreme : extremes_m_) extreme += rounding;
}

double ClearanceBound::at(const Eigen::Isometry3d& X_WO) const {
  double sum = 0.0;
  const Eigen::Array3d last = (lattice_.count.array() - 1).cast<double>();
  for (const Cluster& cluster : clusters_) {
    const Eigen::Array3d place = ((X_WO * cluster.p_O - lattice_.origin_m) / lattice_.cell_m).array();
    const Eigen::Vector3i cell = place.max(0.0).min(last).cast<int>().matrix();
    sum += cluster.share * static_cast<double>(extremes_m_[lattice_.index(cell)]);
  }
  return sum;
}

}  // namespace b4p
