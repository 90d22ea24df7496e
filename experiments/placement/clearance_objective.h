// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "experiments/placement/clearance_bound.h"
#include "experiments/placement/distance_field.h"
#include "planners/placement/placement_objective.h"

namespace b4p {

enum class ClearanceGoal {
  kLargest,   ///< far from everything
  kSmallest,  ///< packed
};

/// The goals by the names that commands and files have for them.
/// @param where, element  named in errors, with the names there are
/// @throws InputError
ClearanceGoal clearanceGoal(const std::string& name, const std::string& where, const std::string& element);
std::string nameOf(ClearanceGoal goal);

/// Clearance C of an object: the mean of DistanceField over points of the object (paper, Section V). The
/// objective is C, or -C for kSmallest; in metres. Immutable.
class ClearanceObjective : public PlacementObjective {
 public:
  /// @param points_O  points spread evenly over the object, in its frame. @throws std::invalid_argument for
  ///   none
  ClearanceObjective(std::shared_ptr<const DistanceField> field, std::vector<Eigen::Vector3d> points_O,
                     ClearanceGoal goal);

  /// C itself (m).
  double clearance(const Eigen::Isometry3d& X_WO) const;

  /// Holds because no point moves farther than the radius plus the chord of its turn, and the field changes
  /// no faster than that but for the grid's error.
  double upperBound(const PoseNeighbourhood& poses) const override;

  double quickBound(const Eigen::Isometry3d& X_WO) const override;

  ClearanceGoal goal() const { return goal_; }

 protected:
  double evaluate(const Eigen::Isometry3d& X_WO) const override;

 private:
  std::shared_ptr<const DistanceField> field_;
  std::vector<Eigen::Vector3d> points_O_;
  ClearanceGoal goal_;
  std::unique_ptr<const ClearanceBound> bound_;
};

}  // namespace b4p
