// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "planners/reach/reach_planner.h"

namespace b4p {

/// Settings of J+-RRT.
struct JPlusRRTParameters {
  double steer_probability =
      0.5;                       ///< that an iteration steers to a grasp instead of growing randomly, 0 ... 1
  bool weighted_grasps = false;  ///< grasps drawn with probability ~ 1 / best distance so far, or uniformly
  double cartesian_step = 0.05;  ///< longest step of the TCP while steering (m), > 0
  unsigned steering_steps = 100;       ///< steps after which steering gives up, >= 1
  double orientation_distance = 0.15;  ///< farther from the grasp only its position counts (m), > 0
  double range = 0.0;  ///< longest random motion, in the metric of the space; 0: as far as it stays free
  bool scaled_metric = true;  ///< nearest nodes by joints in shares of their range, or by the space's metric

  /// Empty when all is in range, otherwise what is not.
  std::string problem() const;
};

/// J+-RRT (Vahrenkamp et al., IROS 2009 and ICRA 2010): an RRT without inverse kinematics.
/// Some iterations draw a grasp and lead the TCP to it from the tree node nearest to it, by steps of the
/// Jacobian's pseudo-inverse; every free step joins the tree.
class JPlusRRT : public ParametrisedReachPlanner<JPlusRRTParameters> {
 public:
  explicit JPlusRRT(const ompl::base::SpaceInformationPtr& si);

 protected:
  std::unique_ptr<ReachSearch> makeSearch(const ReachGoal& goal) override;
};

}  // namespace b4p
