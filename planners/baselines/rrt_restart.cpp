// SPDX-License-Identifier: BSD-3-Clause
#include "planners/baselines/rrt_restart.h"

namespace b4p {

RRTRestart::RRTRestart(const ompl::base::SpaceInformationPtr& si) : BaselinePlanner(si, "RRTRestart") {
  declare("slice", &RRTRestartParameters::slice, "1:1:1000000");
  declare("growth", &RRTRestartParameters::growth, "1.:0.1:10.");
  declare("root_attempts", &RRTRestartParameters::root_attempts, "1:1:10000");
  declareProgress("pairs INTEGER", statistics().pairs);
}

}  // namespace b4p
