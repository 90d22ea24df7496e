// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planners/baselines/baseline_planner.h"
#include "planners/baselines/shared_search.h"

namespace b4p {

/// RRT-Shared (Leebron et al., IROS 2025, section V-A2): "all threads perform one bidirectional RRT in
/// parallel using a single grasp. [...] We set a small time limit and when it expires, the planner restarts
/// and uses a new grasp." The limit is RRTSharedParameters::restart_s or restart_iterations.
///
/// See ParallelPlanner for the life cycle. With one thread and restart_iterations > 0, OMPL's global seed
/// determines the result; restarts by time depend on the machine.
class RRTShared : public BaselinePlanner<RRTSharedParameters, SharedSearch> {
 public:
  explicit RRTShared(const ompl::base::SpaceInformationPtr& si);
};

}  // namespace b4p
