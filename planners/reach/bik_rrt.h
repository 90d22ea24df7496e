// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "planners/reach/reach_planner.h"

namespace b4p {

/// Settings of BIK-RRT.
struct BIKRRTParameters {
  double ik_probability = 0.1;  ///< that an iteration looks for a further goal configuration, 0 < ... <= 1
  unsigned ik_attempts = 5;     ///< of inverse kinematics per such iteration, >= 1
  double range = 0.0;           ///< longest motion, in the metric of the space; 0: as far as it stays free

  /// Empty when all is in range, otherwise what is not.
  std::string problem() const;
};

/// BIK-RRT (Vahrenkamp et al., IROS 2009 and ICRA 2010): RRT-Connect between the trees of the
/// starts and a forest that grows online: some iterations draw a grasp, and a free configuration found by
/// inverse kinematics becomes the root of a further tree.
class BIKRRT : public ParametrisedReachPlanner<BIKRRTParameters> {
 public:
  explicit BIKRRT(const ompl::base::SpaceInformationPtr& si);

 protected:
  std::unique_ptr<ReachSearch> makeSearch(const ReachGoal& goal) override;
};

}  // namespace b4p
