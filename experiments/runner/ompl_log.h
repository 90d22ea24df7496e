// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <ompl/tools/benchmark/Benchmark.h>

namespace b4p {

/// Runs of many planners on one scene, each recorded by an OMPL Benchmark of its own, as one log in OMPL's
/// format. Converters and Planner Arena read it like any other.
class OmplLog : private ompl::tools::Benchmark {
 public:
  /// @param setup   lent; only its type matters to OMPL here
  /// @param header  free text that goes into the log's set-up block
  OmplLog(ompl::geometric::SimpleSetup& setup, const std::string& name, const std::string& header,
          double time_limit_s, int runs, std::uint64_t seed);

  /// Adds the only run in `recorded` under a planner's label. Where OMPL failed to record the run, it counts
  /// as a crash.
  void add(const std::string& label, const CompleteExperiment& recorded, const RunProperties& own_columns);

  std::string text() const;

 private:
  PlannerExperiment& planner(const std::string& label);
};

}  // namespace b4p
