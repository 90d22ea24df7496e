// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "experiments/planners.h"
#include "experiments/query.h"
#include "experiments/runner/experiment.h"
#include "experiments/runner/ompl_log.h"
#include "experiments/runner/run_record.h"
#include "experiments/scene.h"

namespace b4p {

/// Runs an experiment, one OMPL Benchmark per planned run, run 1 of every contender before run 2 of any,
/// since machines are noisy. Each run has a seed derived from (experiment's seed, number of the run), the
/// same for all contenders, a fresh problem, and an exact time limit. After each run the folder holds,
/// complete: SCENE.log in OMPL's format, summary.md, and in results/ a verified result file per solved run.
class BenchmarkRunner {
 public:
  /// Finds out everything that may be wrong with the input before any planning.
  /// @param overwrite  whether logs and result files that the folder holds already (*.log, results/*.json)
  ///   are removed; else they are refused, since they would mix with the new ones
  /// @throws InputError
  BenchmarkRunner(Experiment experiment, PlannerCatalogue catalogue, const std::string& folder,
                  bool overwrite = false);

  /// All runs, or those up to an interrupt (see interrupt.h); the run under way is then dropped.
  void run();

  /// What is going on and for how long still. Any thread may ask.
  std::string progress() const;

  const std::vector<RunRecord>& records() const { return records_; }
  std::size_t plannedRuns() const;
  bool anyFailedVerification() const;
  bool anyCrashed() const;
  bool anySolved() const;

  /// The tables of summary.md.
  std::string report() const;

 private:
  struct SceneRuns {
    std::string given;  ///< name or path
    Scene scene;
    std::unique_ptr<OmplLog> log;
  };

  void runOne(SceneRuns& runs, const Contender& contender, int number);
  ompl::tools::Benchmark::CompleteExperiment benchmark(Query& query, const std::string& name,
                                                       PlanResult& result) const;
  std::string resultFile(const RunRecord& record) const;
  std::string header() const;
  void announce(const std::string& what);
  void writeSummary() const;

  Experiment experiment_;
  PlannerCatalogue catalogue_;
  std::string folder_;
  std::vector<SceneRuns> scenes_;
  std::vector<RunRecord> records_;

  mutable std::mutex progress_mutex_;
  std::string current_;
  std::size_t done_ = 0;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace b4p
