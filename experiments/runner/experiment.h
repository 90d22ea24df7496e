// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/planners.h"

namespace b4p {

/// One column of a comparison: a planner with its settings.
struct Contender {
  std::string label;  ///< a word, unlike the others
  std::string planner;
  unsigned threads = 1;
  PlannerParameters parameters;
};

/// A benchmark as its file describes it (experiments/*.yaml).
struct Experiment {
  std::string file;
  std::string name;
  int runs = 1;               ///< per scene and contender
  double time_limit_s = 0.0;  ///< of each run
  std::uint64_t seed = 1;
  std::vector<std::string> scenes;  ///< as loadScene() takes them
  std::vector<Contender> contenders;
};

/// What a command says in place of an experiment's file.
struct ExperimentOverrides {
  std::optional<int> runs;
  std::optional<std::uint64_t> seed;
  std::optional<unsigned> threads;  ///< of planners that do not state their own
  std::optional<double> time_limit_s;
};

/// @throws InputError naming file, key and value
Experiment loadExperiment(const std::string& file, const ExperimentOverrides& overrides = {});

}  // namespace b4p
