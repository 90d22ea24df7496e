// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planners/baselines/baseline_planner.h"
#include "planners/baselines/restart_search.h"

namespace b4p {

/// RRT-Restart: what one writes who has an RRT-Connect and many grasps, done well. Pairs of a grasp and a
/// placement that both have a root race in slices of iterations that grow from round to round, while new
/// pairs keep joining; none is dropped. Threads work on different pairs.
///
/// See ParallelPlanner for the life cycle. With one thread, OMPL's global seed determines the result.
class RRTRestart : public BaselinePlanner<RRTRestartParameters, RestartSearch> {
 public:
  explicit RRTRestart(const ompl::base::SpaceInformationPtr& si);
};

}  // namespace b4p
