// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <limits>
#include <mutex>
#include <string>

#include <Eigen/Geometry>

namespace b4p {

/// Poses of an object near one of them: point p_WV of the object moved in the horizontal plane by up to
/// `radius_m`, and the object turned about the vertical through it by up to `half_angle_rad`.
struct PoseNeighbourhood {
  Eigen::Isometry3d X_WO;
  Eigen::Vector3d p_WV;
  double radius_m;
  double half_angle_rad;
};

/// How good a pose of the object is: the more, the better (paper, Eq. 1). Any thread may ask. Asking never
/// throws: where evaluate() throws or gives NaN the answer is -infinity and problem() says so from then on.
class PlacementObjective {
 public:
  virtual ~PlacementObjective() = default;

  double value(const Eigen::Isometry3d& X_WO) const;

  /// Change of value() with the position along the world's x and y (per m) and with a turn about the vertical
  /// through the origin of O (per rad), by central differences. Zero where a difference is not finite.
  Eigen::Vector3d planarGradient(const Eigen::Isometry3d& X_WO) const;

  /// A number that value() exceeds nowhere in the neighbourhood. +infinity: nothing is known.
  virtual double upperBound(const PoseNeighbourhood&) const {
    return std::numeric_limits<double>::infinity();
  }

  /// A number that value() does not exceed at this pose, found much sooner than the value. +infinity: nothing
  /// is known. Does not throw.
  virtual double quickBound(const Eigen::Isometry3d&) const {
    return std::numeric_limits<double>::infinity();
  }

  /// What went wrong first; empty when nothing did.
  std::string problem() const;
  bool failed() const { return failed_.load(std::memory_order_acquire); }

  /// The half steps of the differences.
  void setSteps(double step_m, double step_rad);

 protected:
  /// May throw. Reentrant.
  virtual double evaluate(const Eigen::Isometry3d& X_WO) const = 0;

 private:
  void fail(const std::string& problem) const;

  double step_m_ = 5e-3;
  double step_rad_ = 0.02;
  mutable std::atomic<bool> failed_{false};
  mutable std::mutex mutex_;
  mutable std::string problem_;
};

/// Any function of the pose X_WO. It has to be reentrant.
class CallableObjective : public PlacementObjective {
 public:
  /// @throws std::invalid_argument for an empty function
  explicit CallableObjective(std::function<double(const Eigen::Isometry3d&)> function);

 protected:
  double evaluate(const Eigen::Isometry3d& X_WO) const override { return function_(X_WO); }

 private:
  std::function<double(const Eigen::Isometry3d&)> function_;
};

}  // namespace b4p
