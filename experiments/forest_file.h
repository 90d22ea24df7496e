// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "experiments/planning_problem.h"

namespace b4p {

/// Writes a planner's trees as JSON: {"schema": 1, "scene": ..., "openings_m": {grasp id: gripper opening,
/// ...}, "nodes": [{"side": 0 pick | 1 place, "grasp": id, "parent": index or -1, "q": [...]}]}.
/// @param scene name or path of the scene file
/// @throws InputError when the file cannot be written
void writeForests(const std::string& file, const std::string& scene, const PlanningProblem& problem,
                  const ompl::base::Planner& planner);

}  // namespace b4p
