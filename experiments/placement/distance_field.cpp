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

// Plain numbers, since placing spends much of its time here.
double DistanceField::interpolated(double x, double y, double z) const {
  const Eigen::Vector3i last = (lattice_.count.array() - 1).matrix();
  x = std::min(std::max(0.0, x), static_cast<double>(last.x()));
  y = std::min(std::max(0.0, y), static_cast<double>(last.y()));
  z = std::min(std::max(0.0, z), static_cast<double>(last.z()));
  const int i = static_cast<int>(x), j = static_cast<int>(y), k = static_cast<int>(z);
  const auto share_x = static_cast<float>(x - i), share_y = static_cast<float>(y - j),
             share_z = static_cast<float>(z - k);
  const auto wide = static_cast<std::size_t>(lattice_.count.x());
  const std::size_t layer = wide * static_cast<std::size_t>(lattice_.count.y());
  const std::size_t dx = i < last.x() ? 1 : 0, dy = j < last.y() ? wide : 0, dz = k < last.z() ? layer : 0;
  const float* here = distance_m_.data() + static_cast<std::size_t>(i) + wide * static_cast<std::size_t>(j) +
                      layer * static_cast<std::size_t>(k);
  const auto between = [](float a, float b, float share) { return a + share * (b - a); };
  const auto inLayer = [&](const float* corner) {
    return between(between(corner[0], corner[dx], share_x), between(corner[dy], corner[dy + dx], share_x),
                   share_y);
  };
  return static_cast<double>(between(inLayer(here), inLayer(here + dz), share_z));
}

double DistanceField::at(const Eigen::Vector3d& p_W) const {
  const Eigen::Vector3d place = ((p_W - lattice_.origin_m) / lattice_.cell_m).array() - 0.5;
  return interpolated(place.x(), place.y(), place.z());
}

double DistanceField::mean(const Eigen::Isometry3d& X_WP,
                           const std::vector<Eigen::Vector3d>& points_P) const {
  const Eigen::Matrix3d R = X_WP.linear() / lattice_.cell_m;
  const Eigen::Vector3d t = ((X_WP.translation() - lattice_.origin_m) / lattice_.cell_m).array() - 0.5;
  double sum = 0.0;
  for (const Eigen::Vector3d& p : points_P)
    sum += interpolated(R(0, 0) * p.x() + R(0, 1) * p.y() + R(0, 2) * p.z() + t.x(),
                        R(1, 0) * p.x() + R(1, 1) * p.y() + R(1, 2) * p.z() + t.y(),
                        R(2, 0) * p.x() + R(2, 1) * p.y() + R(2, 2) * p.z() + t.z());
  return sum / static_cast<double>(points_P.size());
}

double DistanceField::gridError_m() const { return std::sqrt(2.0) * lattice_.cell_m; }

}  // namespace b4p
