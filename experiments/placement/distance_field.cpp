// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/distance_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace b4p {
namespace {

constexpr float kNowhere = std::numeric_limits<float>::infinity();

/// min over j of (i - j)^2 + values[j], for all i, in place: the lower envelope of parabolas (Felzenszwalb
/// and Huttenlocher, Distance Transforms of Sampled Functions, 2012). In cells.
class SquaredDistances {
 public:
  explicit SquaredDistances(std::size_t longest) : vertex_(longest), from_(longest), result_(longest) {}

  void operator()(float* values, std::size_t count, std::size_t stride) {
    std::size_t parabolas = 0;
    const auto value = [&](std::size_t i) { return static_cast<double>(values[i * stride]); };
    for (std::size_t i = 0; i < count; ++i) {
      if (std::isinf(value(i))) continue;
      double meet = -std::numeric_limits<double>::infinity();
      while (parabolas > 0) {
        const auto a = static_cast<double>(i), b = static_cast<double>(vertex_[parabolas - 1]);
        meet = (value(i) + a * a - value(vertex_[parabolas - 1]) - b * b) / (2.0 * (a - b));
        if (meet > from_[parabolas - 1]) break;
        --parabolas;
      }
      if (parabolas == 0) meet = -std::numeric_limits<double>::infinity();
      vertex_[parabolas] = i;
      from_[parabolas++] = meet;
    }
    if (parabolas == 0) return;
    std::size_t lowest = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto x = static_cast<double>(i);
      while (lowest + 1 < parabolas && from_[lowest + 1] < x) ++lowest;
      const double step = x - static_cast<double>(vertex_[lowest]);
      result_[i] = static_cast<float>(step * step + value(vertex_[lowest]));
    }
    for (std::size_t i = 0; i < count; ++i) values[i * stride] = result_[i];
  }

 private:
  std::vector<std::size_t> vertex_;
  std::vector<double> from_;  ///< where each parabola begins to be the lowest
  std::vector<float> result_;
};

}  // namespace

DistanceField::DistanceField(const OccupancyGrid& grid)
    : lattice_(grid.lattice()), distance_m_(lattice_.size(), kNowhere) {
  const Eigen::Vector3i n = lattice_.count;
  const auto layer = static_cast<std::size_t>(n.x()) * static_cast<std::size_t>(n.y());
  // Along z, looking up only.
  for (int y = 0; y < n.y(); ++y)
    for (int x = 0; x < n.x(); ++x) {
      int above = -1;
      for (int z = n.z() - 1; z >= 0; --z) {
        if (grid.occupied({x, y, z})) above = z;
        if (above >= 0)
          distance_m_[lattice_.index({x, y, z})] = static_cast<float>((above - z) * (above - z));
      }
    }
  SquaredDistances transform(static_cast<std::size_t>(std::max(n.x(), n.y())));
  for (int z = 0; z < n.z(); ++z) {
    float* values = distance_m_.data() + layer * static_cast<std::size_t>(z);
    for (int y = 0; y < n.y(); ++y)
      transform(values + static_cast<std::size_t>(y) * static_cast<std::size_t>(n.x()),
                static_cast<std::size_t>(n.x()), 1);
    for (int x = 0; x < n.x(); ++x)
      transform(values + x, static_cast<std::size_t>(n.y()), static_cast<std::size_t>(n.x()));
  }
  const auto diagonal = static_cast<float>(n.cast<double>().norm());
  for (float& value : distance_m_)
    value = static_cast<float>(lattice_.cell_m) * (std::isinf(value) ? diagonal : std::sqrt(value));
}

double DistanceField::at(const Eigen::Vector3d& p_W) const {
  const Eigen::Array3d last = (lattice_.count.array() - 1).cast<double>();
  const Eigen::Array3d place = ((p_W - lattice_.origin_m).array() / lattice_.cell_m - 0.5).max(0.0).min(last);
  const Eigen::Array3i low = place.cast<int>();
  const Eigen::Array3d share = place - low.cast<double>();
  const Eigen::Array3i step = (low + 1 < lattice_.count.array()).cast<int>();
  const std::size_t base = lattice_.index(low.matrix());
  const auto dx = static_cast<std::size_t>(step.x());
  const auto dy = static_cast<std::size_t>(step.y()) * static_cast<std::size_t>(lattice_.count.x());
  const auto dz = static_cast<std::size_t>(step.z()) * static_cast<std::size_t>(lattice_.count.x()) *
                  static_cast<std::size_t>(lattice_.count.y());
  const auto alongX = [&](std::size_t i) {
    const double a = static_cast<double>(distance_m_[i]), b = static_cast<double>(distance_m_[i + dx]);
    return a + share.x() * (b - a);
  };
  const auto inLayer = [&](std::size_t i) {
    const double a = alongX(i);
    return a + share.y() * (alongX(i + dy) - a);
  };
  const double bottom = inLayer(base);
  return share.z() == 0.0 ? bottom : bottom + share.z() * (inLayer(base + dz) - bottom);
}

double DistanceField::gridError_m() const { return std::sqrt(2.0) * lattice_.cell_m; }

}  // namespace b4p
