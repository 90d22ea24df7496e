// SPDX-License-Identifier: BSD-3-Clause
#include "planners/reach/bik_rrt.h"

#include <cmath>

#include <ompl/util/RandomNumbers.h>

#include "planners/reach/bik_search.h"

namespace b4p {

namespace ob = ompl::base;

std::string BIKRRTParameters::problem() const {
  if (!(ik_probability > 0.0 && ik_probability <= 1.0))
    return "ik_probability must be above 0 and at most 1 (" + std::to_string(ik_probability) + ")";
  if (ik_attempts < 1) return "ik_attempts must be at least 1 (0)";
  if (!(range >= 0.0) || !std::isfinite(range))
    return "range must be finite and >= 0 (" + std::to_string(range) + ")";
  return "";
}

BIKRRT::BIKRRT(const ob::SpaceInformationPtr& si) : WithParameters(si, "BIKRRT") {
  declare("ik_probability", &BIKRRTParameters::ik_probability, "0.01:0.01:1.");
  declare("ik_attempts", &BIKRRTParameters::ik_attempts, "1:1:100000");
  declare("range", &BIKRRTParameters::range, "0.:0.01:10000.");
}

std::unique_ptr<ReachSearch> BIKRRT::makeSearch(const ReachGoal& goal) {
  return std::make_unique<BikSearch>(si_, goal, parameters(), ompl::RNG().getLocalSeed(), statistics());
}

}  // namespace b4p
