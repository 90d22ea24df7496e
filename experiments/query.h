// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "experiments/checker_choice.h"
#include "experiments/deadline_planner.h"
#include "experiments/planners.h"
#include "experiments/planning_problem.h"
#include "experiments/result.h"
#include "experiments/run_limits.h"
#include "experiments/scene.h"

namespace b4p {

/// How a scene is to be solved.
struct QuerySettings {
  std::string planner = "b4p";
  CheckerKind checker = CheckerKind::kFast;
  PlannerParameters parameters;
  std::uint64_t seed = 1;
  unsigned threads = 1;
  double time_limit_s = 0.0;                      ///< > 0
  std::optional<std::uint64_t> check_limit = {};  ///< configurations checked (see RunLimits), none: no limit
  StopRule stop = StopRule::kEither;              ///< where there is a check limit
  RunClock clock = RunClock::kElapsed;            ///< of the time limit and of planning_time_s
};

/// One run of one planner on one scene. The time limit covers all that happens after construction: the
/// drawing of start states (planners that draw picks by themselves get none), the planner, the joining of its
/// threads. On one thread the seed determines the path.
///
/// Seeds OMPL's global generator, so only one query may be made and run at a time in a process.
class Query {
 public:
  /// @param scene_name  as loadScene() takes it; for the result file
  /// @param where       named in errors about planner and parameters
  /// @throws InputError
  Query(const Scene& scene, const std::string& scene_name, const PlannerCatalogue& catalogue,
        const QuerySettings& settings, const std::string& where);

  const PlanningProblem& problem() const { return *problem_; }
  const std::shared_ptr<DeadlinePlanner>& planner() const { return planner_; }

  /// Runs the planner. Exceptions out of it become the status CRASH.
  void solve();

  /// What came of it, not verified yet.
  PlanResult result(const ompl::base::PlannerStatus& status) const;
  PlanResult result() const { return result(status_); }

  /// Configurations checked for the planner, along motions included, and motions it asked for; not counting
  /// those of others before and afterwards.
  std::uint64_t configurationsChecked() const { return configurations_; }
  std::uint64_t edgeChecks() const { return edge_checks_; }

  /// Processor time of all threads while the planner ran (s).
  double cpu_s() const { return planner_->cpu_s(); }

 private:
  std::string scene_name_;
  QuerySettings settings_;
  std::unique_ptr<PlanningProblem> problem_;
  std::shared_ptr<DeadlinePlanner> planner_;
  ompl::base::PlannerStatus status_;
  std::uint64_t configurations_ = 0;
  std::uint64_t edge_checks_ = 0;
};

/// What a planner's status and the solution path of a problem say: status, joints, path, grasp and poses.
PlanResult pathResult(const PlanningProblem& problem, const ompl::base::PlannerStatus& status);

/// Whether the planner ended by an exception, its own handling of it included.
bool crashed(const PlanResult& result);

/// @throws InputError unless a time limit (s) is positive and finite
void requireTimeLimit(double time_limit_s, const std::string& where, const std::string& element);

}  // namespace b4p
