// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <ompl/base/StateSpace.h>
#include <Eigen/Core>

#include "planners/b4p/forest.h"

namespace b4p {

/// What reach planners know of a state space: its joint values and their limits, taken at construction. Works
/// on OMPL's RealVectorStateSpace and on ManipulationStateSpace. Immutable; any thread may ask.
class JointSpace {
 public:
  /// @throws std::invalid_argument for any other space, and for limits that are not finite or reversed
  explicit JointSpace(const ompl::base::StateSpacePtr& space);

  unsigned dof() const { return static_cast<unsigned>(lower_.size()); }
  const Eigen::VectorXd& lower() const { return lower_; }  ///< rad or m
  const Eigen::VectorXd& upper() const { return upper_; }

  double* q(ompl::base::State* state) const;  ///< dof() values
  const double* q(const ompl::base::State* state) const;

  /// True when all values are finite and inside the limits (inclusive).
  bool contains(const double* q) const;

  /// Euclidean, each joint in shares of its range.
  StateDistance scaledDistance() const;

 private:
  bool carries_grasps_;
  Eigen::VectorXd lower_, upper_;
};

}  // namespace b4p
