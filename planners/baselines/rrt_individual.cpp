// SPDX-License-Identifier: BSD-3-Clause
#include "planners/baselines/rrt_individual.h"

namespace b4p {

RRTIndividual::RRTIndividual(const ompl::base::SpaceInformationPtr& si)
    : BaselinePlanner(si, "RRTIndividual") {
  declare("redraw", &RRTIndividualParameters::redraw, "0,1");
  declareProgress("threads with both roots INTEGER", statistics().pairs);
}

}  // namespace b4p
