// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/samplers/placement_sampler.h"

#include <algorithm>
#include <cmath>

namespace b4p {

PlacementSampler::PlacementSampler(const PlacementSource& source, const Eigen::Isometry3d& X_WO_start,
                                   double margin_m, double upright_tolerance_rad)
    : source_(source),
      margin_m_(margin_m),
      upright_tolerance_rad_(upright_tolerance_rad),
      R_WO_(X_WO_start.linear()) {
  for (int i = 0; i < 3; ++i) {
    const double margin = std::min(margin_m, (source.max_m[i] - source.min_m[i]) / 2.0);
    low_[i] = source.min_m[i] + margin;
    high_[i] = source.max_m[i] - margin;
  }
  if (source.upright) {
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    R_WO_ = Eigen::Quaterniond::FromTwoVectors(R_WO_.col(2), up).toRotationMatrix() * R_WO_;
  }
}

Eigen::Isometry3d PlacementSampler::sample(std::mt19937_64& random) const {
  const auto between = [&random](double low, double high) {
    return low < high ? std::uniform_real_distribution<double>(low, high)(random) : low;
  };
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 3; ++i) X_WO.translation()[i] = between(low_[i], high_[i]);
  const double yaw = between(source_.yaw_min_rad, source_.yaw_max_rad);
  X_WO.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix() * R_WO_;
  return X_WO;
}

double PlacementSampler::distance(const Eigen::Isometry3d& X_WO) const {
  const Eigen::Vector3d p = X_WO.translation();
  const double outside =
      std::max(0.0, (p - p.cwiseMax(source_.min_m).cwiseMin(source_.max_m)).norm() - margin_m_);
  if (!source_.upright) return outside;
  const Eigen::Vector3d z = X_WO.linear().col(2);
  return outside + std::max(0.0, std::atan2(std::hypot(z.x(), z.y()), z.z()) - upright_tolerance_rad_);
}

}  // namespace b4p
