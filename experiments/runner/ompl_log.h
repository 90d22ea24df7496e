// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include <ompl/tools/benchmark/Benchmark.h>

#include "experiments/runner/run_record.h"

namespace b4p {

/// The memory limit (MB) that logs state; there is none.
constexpr double kNoMemoryLimit_MB = 1e6;

/// Takes the only run out of what an OMPL Benchmark recorded. Where OMPL failed to record the run, it counts
/// as a crash.
/// @param own_columns  "NAME TYPE" -> value, beside or in place of OMPL's
OmplRun omplRun(const ompl::tools::Benchmark::CompleteExperiment& recorded,
                const std::map<std::string, std::string>& own_columns);

/// Runs of many planners on one scene, each recorded by an OMPL Benchmark of its own, as one log in OMPL's
/// format. Converters and Planner Arena read it like any other.
class OmplLog : private ompl::tools::Benchmark {
 public:
  /// @param header  free text that goes into the log's set-up block
  OmplLog(const std::string& name, const std::string& header, double time_limit_s, int runs,
          std::uint64_t seed);

  void add(const RunRecord& record);
  bool empty() const { return exp_.planners.empty(); }
  std::string text();

 private:
  PlannerExperiment& planner(const std::string& label);
};

}  // namespace b4p
