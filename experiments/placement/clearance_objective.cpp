// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/clearance_objective.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "experiments/named_values.h"

namespace b4p {
namespace {

constexpr std::array<Named<ClearanceGoal>, 2> kGoals{
    {{ClearanceGoal::kLargest, "max_clearance"}, {ClearanceGoal::kSmallest, "min_clearance"}}};

}  // namespace

ClearanceGoal clearanceGoal(const std::string& name, const std::string& where, const std::string& element) {
  return valueOf(kGoals, name, where, element);
}

std::string nameOf(ClearanceGoal goal) { return nameIn(kGoals, goal); }

ClearanceObjective::ClearanceObjective(std::shared_ptr<const DistanceField> field,
                                       std::vector<Eigen::Vector3d> points_O, ClearanceGoal goal)
    : field_(std::move(field)), points_O_(std::move(points_O)), goal_(goal) {
  if (field_ == nullptr || points_O_.empty())
    throw std::invalid_argument("clearance needs a distance field and points of the object");
  bound_ = std::make_unique<const ClearanceBound>(
      *field_, points_O_, goal_ == ClearanceGoal::kLargest ? BoundSide::kAbove : BoundSide::kBelow);
}

double ClearanceObjective::clearance(const Eigen::Isometry3d& X_WO) const {
  return field_->mean(X_WO, points_O_);
}

double ClearanceObjective::evaluate(const Eigen::Isometry3d& X_WO) const {
  const double c = clearance(X_WO);
  return goal_ == ClearanceGoal::kLargest ? c : -c;
}

double ClearanceObjective::quickBound(const Eigen::Isometry3d& X_WO) const {
  const double c = bound_->at(X_WO);
  return goal_ == ClearanceGoal::kLargest ? c : -c;
}

double ClearanceObjective::upperBound(const PoseNeighbourhood& poses) const {
  constexpr double kPi = 3.14159265358979323846, kRounding_m = 1e-6;
  double value = 0.0, arm = 0.0;
  for (const Eigen::Vector3d& p_O : points_O_) {
    const Eigen::Vector3d p_W = poses.X_WO * p_O;
    value += field_->at(p_W);
    arm += (p_W - poses.p_WV).head<2>().norm();
  }
  const auto count = static_cast<double>(points_O_.size());
  const double chord = 2.0 * arm / count * std::sin(std::min(poses.half_angle_rad, kPi) / 2.0);
  const double way = poses.radius_m + chord;
  const double change = std::min(std::sqrt(2.0) * way, way + field_->gridError_m());
  return (goal_ == ClearanceGoal::kLargest ? value : -value) / count + change + kRounding_m;
}

}  // namespace b4p
