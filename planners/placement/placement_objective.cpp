// SPDX-License-Identifier: BSD-3-Clause
#include "planners/placement/placement_objective.h"

#include <cmath>
#include <exception>
#include <stdexcept>
#include <utility>

namespace b4p {

double PlacementObjective::value(const Eigen::Isometry3d& X_WO) const {
  try {
    const double value = evaluate(X_WO);
    if (!std::isnan(value)) return value;
    fail("the objective is not a number");
  } catch (const std::exception& e) {
    fail(std::string("the objective failed: ") + e.what());
  } catch (...) {
    fail("the objective failed with an exception of unknown type");
  }
  return -std::numeric_limits<double>::infinity();
}

Eigen::Vector3d PlacementObjective::planarGradient(const Eigen::Isometry3d& X_WO) const {
  const auto moved = [&](int axis, double step) {
    Eigen::Isometry3d X = X_WO;
    if (axis < 2)
      X.translation()[axis] += step;
    else
      X.linear() = Eigen::AngleAxisd(step, Eigen::Vector3d::UnitZ()) * X_WO.linear();
    return value(X);
  };
  Eigen::Vector3d gradient;
  for (int axis = 0; axis < 3; ++axis) {
    const double step = axis < 2 ? step_m_ : step_rad_;
    const double slope = (moved(axis, step) - moved(axis, -step)) / (2.0 * step);
    gradient[axis] = std::isfinite(slope) ? slope : 0.0;
  }
  return gradient;
}

std::string PlacementObjective::problem() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return problem_;
}

void PlacementObjective::setSteps(double step_m, double step_rad) {
  if (!(step_m > 0.0) || !(step_rad > 0.0) || !std::isfinite(step_m + step_rad))
    throw std::invalid_argument("the steps of an objective's gradient have to be positive and finite");
  step_m_ = step_m;
  step_rad_ = step_rad;
}

void PlacementObjective::fail(const std::string& problem) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (problem_.empty()) problem_ = problem;
  failed_.store(true, std::memory_order_release);
}

CallableObjective::CallableObjective(std::function<double(const Eigen::Isometry3d&)> function)
    : function_(std::move(function)) {
  if (!function_) throw std::invalid_argument("the objective has no function");
}

}  // namespace b4p
