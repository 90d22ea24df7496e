// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "experiments/result.h"
#include "experiments/scene.h"
#include "experiments/verification/kinematics.h"

namespace b4p::verification {

/// The path begins at the task's start (within 1e-9 rad or m), and at its end the TCP is, with the fingers
/// fully open, within the task's tolerance of the grasp that grasp_id names (or of its flip, where that
/// counts) and where the result says.
/// @param result  with complete rows
/// @return the first thing found wrong, one line naming way-point and value, or an empty string
std::string reachProblem(const ReachTask& task, const PlanResult& result, const Kinematics& robot,
                         double max_opening_m);

}  // namespace b4p::verification
