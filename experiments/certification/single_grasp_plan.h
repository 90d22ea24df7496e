// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "experiments/problem.h"
#include "experiments/result.h"

namespace b4p {

/// OMPL's RRTConnect from picks of one grasp to placements with that grasp, for at most `effort_s` seconds of
/// the thread's processor time (or until interrupted()), so that a busy machine makes no difference. Its
/// samples and placements depend on the seed alone, whatever other threads do. Not verified.
/// @param problem  with one grasp, not used before: it gets the start states
/// @param picks    at least one configuration
PlanResult planWithOneGrasp(Problem& problem, const std::vector<std::vector<double>>& picks,
                            std::uint64_t seed, double effort_s);

}  // namespace b4p
