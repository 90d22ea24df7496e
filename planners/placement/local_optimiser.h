// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <Eigen/Core>

#include "planners/placement/placement_goal.h"

namespace b4p {

/// Settings of a LocalOptimiser.
struct LocalOptimisation {
  double step = 0.01;    ///< length of a joint step (rad; m for sliding joints), > 0
  unsigned steps = 100;  ///< at most so many
  double flat_gradient =
      0.01;  ///< the objective's gradient (1 / m, 1 / rad) below which it counts as flat, >= 0

  /// Empty when all is in range, otherwise what is not.
  std::string problem() const;
};

/// Why a local optimisation ended.
enum class LocalEnd {
  kFlat,         ///< the gradient vanishes
  kNoGain,       ///< the objective falls
  kCollision,    ///< of arm or object
  kLostContact,  ///< the object would not stand
  kJointLimit,
  kSingular,  ///< the Jacobian's rank is less than 6
  kSteps,     ///< all steps have been made
  kTold       ///< the termination condition holds
};

/// Improves a placement by steps of the joints along J+ v, where v lifts the objective's gradient over x, y
/// and the turn about the vertical to a velocity of the TCP (Haustein et al., IROS 2019, section IV-E). After
/// each step height and tilt of the object are led back to what they were, which steps of first order do not
/// keep. For one thread. Throws what the goal's world throws.
class LocalOptimiser {
 public:
  /// @param goal  has to outlive the optimiser
  LocalOptimiser(const ompl::base::SpaceInformationPtr& si, const PlacementGoal& goal,
                 const LocalOptimisation& settings);

  struct Result {
    /// The states after `from`, each with a motion from the one before that the problem's motion validator
    /// accepts; at each the object is stable and free, and the last one has the highest objective.
    std::vector<ompl::base::ScopedState<>> states;
    double objective;  ///< of the last state
    LocalEnd end;
  };

  /// @param from       a state whose placement is valid
  /// @param objective  of that state
  Result improve(const ompl::base::State* from, double objective,
                 const ompl::base::PlannerTerminationCondition& ptc);

 private:
  LocalEnd step(const ompl::base::State* here, double& value, ompl::base::State* next);
  Eigen::VectorXd ascent(GraspId arm, const Eigen::VectorXd& q, const Eigen::Isometry3d& X_WO,
                         const Eigen::Vector3d& gradient);
  void keepUpright(GraspId arm, const Eigen::Isometry3d& X_WO, Eigen::VectorXd& q);

  ompl::base::SpaceInformationPtr si_;
  const PlacementGoal& goal_;
  LocalOptimisation settings_;
  std::unique_ptr<PlacementContext> context_;
};

}  // namespace b4p
