// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "experiments/json_value.h"
#include "experiments/result.h"

namespace b4p {

/// What a result file holds, as part of another file. @throws std::invalid_argument as writeResult() does.
Json resultJson(const PlanResult& result);

/// Position and rotation matrix. @throws std::invalid_argument when it is not finite, naming `name`.
Json poseJson(const Eigen::Isometry3d& X, const char* name);

/// @throws InputError as readResult() does
Eigen::Isometry3d poseFrom(const JsonValue& value);

Json graspJson(const Grasp& grasp);

/// @throws InputError as readResult() does
Grasp graspFrom(const JsonValue& value);

/// @throws InputError as readResult() does
PlanResult resultFrom(const JsonValue& root);

}  // namespace b4p
