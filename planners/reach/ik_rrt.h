// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "planners/reach/reach_planner.h"

namespace b4p {

/// Settings of IK-RRT. Budgets are those of the first round over all grasps; round n has n times as much.
struct IKRRTParameters {
  unsigned ik_attempts = 20;  ///< random restarts of inverse kinematics per grasp, >= 1
  unsigned iterations = 20;   ///< of the search to a goal configuration before its grasp is dropped, >= 1
  double goal_bias = 0.1;     ///< share of iterations that grow to goal configurations, 0 < ... <= 1
  double range = 0.0;         ///< longest motion, in the metric of the space; 0: as far as it stays free

  /// Empty when all is in range, otherwise what is not.
  std::string problem() const;
};

/// IK-RRT (Vahrenkamp et al., IROS 2009 and ICRA 2010): grasps are tried one after the other
/// in random order, each once a round. Inverse kinematics with random restarts gives a free goal
/// configuration, an RRT from the starts grows to it. A grasp is dropped when no free configuration is found
/// or the search runs out.
class IKRRT : public ParametrisedReachPlanner<IKRRTParameters> {
 public:
  explicit IKRRT(const ompl::base::SpaceInformationPtr& si);

 protected:
  std::unique_ptr<ReachSearch> makeSearch(const ReachGoal& goal) override;
};

}  // namespace b4p
