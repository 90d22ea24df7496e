// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/deadline_planner.h"
#include "experiments/placement/placement_parameters.h"
#include "experiments/placement/placement_problem.h"
#include "experiments/placement/placement_result.h"
#include "experiments/planners.h"

namespace b4p {

/// How a placement scene is to be solved.
struct PlacementQuerySettings {
  std::optional<ClearanceGoal> objective = {};  ///< none: the scene's own
  PlacementOptions options;
  PlannerParameters parameters;  ///< of the planner `placement`; over `options`
  unsigned threads = 1;
  std::uint64_t seed = 1;
  double time_limit_s = 0.0;            ///< > 0
  RunClock clock = RunClock::kElapsed;  ///< of the time limit and of all times in the result
};

/// One run of the planner `placement` on a scene. The time limit covers all that happens after construction.
/// Seeds OMPL's global generator, so only one query may be made and run at a time in a process.
class PlacementQuery {
 public:
  /// @param scene_name  for the result file
  /// @param where       named in errors about parameters
  /// @throws InputError as makePlacementProblem() does, and for parameters
  PlacementQuery(const Scene& scene, const std::string& scene_name, const PlacementQuerySettings& settings,
                 const std::string& where);

  PlacementQuery(const PlacementQuery&) = delete;
  PlacementQuery& operator=(const PlacementQuery&) = delete;

  /// What is wrong with settings, found without a scene. @throws InputError
  static void check(const PlacementQuerySettings& settings, const std::string& where);

  const std::shared_ptr<DeadlinePlanner>& planner() const { return planner_; }
  const PlacementProblem& problem() const { return problem_; }

  /// Plans until the time limit, an interrupt, or when nothing better is left. Not verified yet.
  PlacementResult solve();

  /// What has come of the planner's last run. Not verified yet.
  PlacementResult result(const ompl::base::PlannerStatus& status) const;

 private:
  void keep(const std::vector<const ompl::base::State*>& states, ompl::base::Cost cost);
  PlacementResult emptyResult() const;
  std::string reason(const PlacementStatistics& draws) const;

  std::string scene_name_;
  PlacementQuerySettings settings_;
  std::shared_ptr<PlacementOptions> options_;
  PlacementProblem problem_;
  std::shared_ptr<DeadlinePlanner> planner_;
  std::vector<PlacementImprovement> improvements_;
  std::chrono::steady_clock::time_point start_;
  double cpu_start_s_ = 0.0;
};

}  // namespace b4p
