// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planners/baselines/baseline_planner.h"
#include "planners/baselines/individual_search.h"

namespace b4p {

/// RRT-Individual (Leebron et al., IROS 2025, section V-A2): "each thread t performs bidirectional RRT using
/// its own individual sampled grasp". A thread takes one grasp with a valid pick and one placement that has a
/// place root for it, and never changes either; see RRTIndividualParameters::redraw. The first thread whose
/// trees meet ends the search.
///
/// See ParallelPlanner for the life cycle. With one thread, OMPL's global seed determines the result.
class RRTIndividual : public BaselinePlanner<RRTIndividualParameters, IndividualSearch> {
 public:
  explicit RRTIndividual(const ompl::base::SpaceInformationPtr& si);
};

}  // namespace b4p
