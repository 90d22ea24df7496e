// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/checker_choice.h"
#include "experiments/placement/clearance_objective.h"
#include "experiments/planners.h"
#include "experiments/run_limits.h"
#include "experiments/scene.h"

namespace b4p {

/// One column of a comparison: a planner with its settings.
struct Contender {
  std::string label;  ///< a word, unlike the others
  std::string planner;
  unsigned threads = 1;
  PlannerParameters parameters;
  std::map<std::string, PlannerParameters> scene_parameters = {};  ///< over `parameters`, by scene as listed
  int runs = 0;                                                    ///< per scene; 0: as the experiment says
  CheckerKind checker = CheckerKind::kFast;

  /// Those of a scene, given as the experiment lists it.
  PlannerParameters parametersFor(const std::string& scene) const;
};

/// A benchmark as its file describes it (experiments/*.yaml).
struct Experiment {
  std::string file;
  std::string name;
  int runs = 1;                        ///< per scene and contender, where those do not say
  std::optional<double> time_limit_s;  ///< of each run; none: each scene's budget_s
  StopRule stop = StopRule::kEither;
  RunClock clock = RunClock::kElapsed;
  /// What a check costs where the budgets come from (us): the check limit of a run is its time limit times
  /// its threads over this.
  std::optional<double> check_cost_us = {};
  std::map<std::string, std::uint64_t> check_limits = {};  ///< of each run, by scene as listed
  std::uint64_t seed = 1;
  std::vector<std::string> scenes;             ///< as loadScene() takes them
  std::vector<ClearanceGoal> objectives = {};  ///< of placement scenes, in place of their own; empty: theirs
  std::vector<Contender> contenders;
  std::vector<unsigned> left_out_threads = {};  ///< asked for by the file, but more than there are cores

  int runsOf(const Contender& contender) const { return contender.runs > 0 ? contender.runs : runs; }

  /// @param given  the scene as listed
  RunLimits limitsFor(const Contender& contender, const std::string& given, const Scene& scene) const;
};

/// What a command says in place of an experiment's file.
struct ExperimentOverrides {
  std::optional<int> runs;  ///< of all planners
  std::optional<std::uint64_t> seed;
  std::vector<unsigned> threads;  ///< of planners that do not state their own; empty: the file's
  std::optional<double> time_limit_s;
  std::optional<RunClock> clock = {};
  std::optional<CheckerKind> checker;  ///< of all planners
  std::vector<std::string> scenes;     ///< some of the file's, as names or patterns; empty: all
};

/// The clocks by the names that commands and files have for them.
/// @throws InputError listing the names there are
RunClock runClock(const std::string& name, const std::string& where, const std::string& element);
std::string nameOf(RunClock clock);

/// @throws InputError naming file, key and value
Experiment loadExperiment(const std::string& file, const ExperimentOverrides& overrides = {});

}  // namespace b4p
