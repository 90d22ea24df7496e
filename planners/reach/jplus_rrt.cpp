// SPDX-License-Identifier: BSD-3-Clause
#include "planners/reach/jplus_rrt.h"

#include <cmath>

#include <ompl/util/RandomNumbers.h>

#include "planners/reach/jplus_search.h"

namespace b4p {

namespace ob = ompl::base;

std::string JPlusRRTParameters::problem() const {
  const auto positive = [](double value) { return std::isfinite(value) && value > 0.0; };
  if (!(steer_probability >= 0.0 && steer_probability <= 1.0))
    return "steer_probability must be 0 ... 1 (" + std::to_string(steer_probability) + ")";
  if (!positive(cartesian_step))
    return "cartesian_step must be finite and > 0 (" + std::to_string(cartesian_step) + ")";
  if (steering_steps < 1) return "steering_steps must be at least 1 (0)";
  if (!positive(orientation_distance))
    return "orientation_distance must be finite and > 0 (" + std::to_string(orientation_distance) + ")";
  if (!(range >= 0.0) || !std::isfinite(range))
    return "range must be finite and >= 0 (" + std::to_string(range) + ")";
  return "";
}

JPlusRRT::JPlusRRT(const ob::SpaceInformationPtr& si) : WithParameters(si, "JPlusRRT") {
  declare("steer_probability", &JPlusRRTParameters::steer_probability, "0.:0.01:1.");
  declare("weighted_grasps", &JPlusRRTParameters::weighted_grasps, "0,1");
  declare("cartesian_step", &JPlusRRTParameters::cartesian_step, "0.001:0.001:1.");
  declare("steering_steps", &JPlusRRTParameters::steering_steps, "1:1:100000");
  declare("orientation_distance", &JPlusRRTParameters::orientation_distance, "0.001:0.001:100.");
  declare("range", &JPlusRRTParameters::range, "0.:0.01:10000.");
  declare("scaled_metric", &JPlusRRTParameters::scaled_metric, "0,1");
}

std::unique_ptr<ReachSearch> JPlusRRT::makeSearch(const ReachGoal& goal) {
  return std::make_unique<JPlusSearch>(si_, goal, parameters(), ompl::RNG().getLocalSeed(), statistics());
}

}  // namespace b4p
