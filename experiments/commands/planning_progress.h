// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/Planner.h>

#include "experiments/commands/progress_line.h"

namespace b4p {

/// Shows the time since now, of `time_limit_s`, and the planner's progress properties, as long as it lives.
/// @param planner  has to outlive it
ProgressLine planningProgress(const ompl::base::Planner& planner, double time_limit_s);

}  // namespace b4p
