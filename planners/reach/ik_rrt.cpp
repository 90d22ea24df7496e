// SPDX-License-Identifier: BSD-3-Clause
#include "planners/reach/ik_rrt.h"

#include <cmath>

#include <ompl/util/RandomNumbers.h>

#include "planners/reach/ik_search.h"

namespace b4p {

namespace ob = ompl::base;

std::string IKRRTParameters::problem() const {
  if (ik_attempts < 1) return "ik_attempts must be at least 1 (0)";
  if (iterations < 1) return "iterations must be at least 1 (0)";
  if (!(goal_bias > 0.0 && goal_bias <= 1.0))
    return "goal_bias must be above 0 and at most 1 (" + std::to_string(goal_bias) + ")";
  if (!(range >= 0.0) || !std::isfinite(range))
    return "range must be finite and >= 0 (" + std::to_string(range) + ")";
  return "";
}

IKRRT::IKRRT(const ob::SpaceInformationPtr& si) : WithParameters(si, "IKRRT") {
  declare("ik_attempts", &IKRRTParameters::ik_attempts, "1:1:100000");
  declare("iterations", &IKRRTParameters::iterations, "1:1:1000000");
  declare("goal_bias", &IKRRTParameters::goal_bias, "0.01:0.01:1.");
  declare("range", &IKRRTParameters::range, "0.:0.01:10000.");
}

std::unique_ptr<ReachSearch> IKRRT::makeSearch(const ReachGoal& goal) {
  return std::make_unique<IkSearch>(si_, goal, parameters(), ompl::RNG().getLocalSeed(), statistics());
}

}  // namespace b4p
