// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "experiments/placement/placement_problem.h"
#include "experiments/placement/placement_result.h"
#include "experiments/planners.h"
#include "planners/placement/placement_planner.h"

namespace b4p {

/// How a placement scene is to be solved.
struct PlacementQuerySettings {
  std::optional<ClearanceGoal> objective = {};  ///< none: the scene's own
  PlacementOptions options;
  PlannerParameters parameters;  ///< of PlacementPlanner
  std::uint64_t seed = 1;
  double time_limit_s = 0.0;  ///< > 0
};

/// One run of PlacementPlanner on a scene. The time limit covers all that happens after construction. Seeds
/// OMPL's global generator, so only one query may be made and run at a time in a process.
class PlacementQuery {
 public:
  /// @param scene_name  for the result file
  /// @param where       named in errors about parameters
  /// @throws InputError as makePlacementProblem() does, and for parameters
  PlacementQuery(const Scene& scene, const std::string& scene_name, const PlacementQuerySettings& settings,
                 const std::string& where);

  const PlacementPlanner& planner() const { return *planner_; }
  const PlacementProblem& problem() const { return problem_; }

  /// Plans until the time limit, an interrupt, or when nothing better is left. Not verified yet.
  PlacementResult solve();

 private:
  PlacementResult emptyResult() const;
  std::string reason(const PlacementStatistics& draws) const;

  std::string scene_name_;
  PlacementQuerySettings settings_;
  PlacementProblem problem_;
  std::shared_ptr<PlacementPlanner> planner_;
};

/// The objectives and ways of sampling by the names that commands and files have for them.
/// @throws InputError listing the names there are
ClearanceGoal clearanceGoal(const std::string& name, const std::string& where);
PlacementSampling placementSampling(const std::string& name, const std::string& where);
std::string nameOf(ClearanceGoal goal);
std::string nameOf(PlacementSampling sampling);

}  // namespace b4p
