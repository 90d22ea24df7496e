// SPDX-License-Identifier: BSD-3-Clause
#include "planners/baselines/rrt_shared.h"

namespace b4p {

RRTShared::RRTShared(const ompl::base::SpaceInformationPtr& si) : BaselinePlanner(si, "RRTShared") {
  declare("redraw", &RRTSharedParameters::redraw, "0,1");
  declare("restart_s", &RRTSharedParameters::restart_s, "0.001:0.001:1000000.");
  declare("restart_iterations", &RRTSharedParameters::restart_iterations, "0:1:1000000000");
  declareProgress("pairs INTEGER", statistics().pairs);
  declareProgress("restarts INTEGER", statistics().restarts);
}

}  // namespace b4p
