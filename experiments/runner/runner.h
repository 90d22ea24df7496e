// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "experiments/planners.h"
#include "experiments/query.h"
#include "experiments/runner/experiment.h"
#include "experiments/runner/ompl_log.h"
#include "experiments/runner/run_file.h"
#include "experiments/runner/settings_file.h"
#include "experiments/runner/time_left.h"

namespace b4p {

class BenchmarkRun;

/// What becomes of an earlier benchmark that the folder holds already.
enum class EarlierRuns {
  kRefuse,  ///< an error: it would mix with the new one
  kRemove,
  kResume,  ///< runs that are recorded are kept and not repeated; the settings have to be the same
};

/// Runs an experiment, one OMPL Benchmark per planned run, run 1 of every contender on every scene before run
/// 2 of any, since machines are noisy. Each run has a seed derived from (experiment's seed, number of the
/// run), the same for all contenders, a fresh problem, and exact limits. A run that has ended is in
/// runs.jsonl, and its result file in results/ where solved, before the next begins; from these SCENE.log in
/// OMPL's format and summary.md are made, complete after each run. So whatever ends the process costs the run
/// under way at most.
class BenchmarkRunner {
 public:
  /// Finds out everything that may be wrong with the input before any planning.
  /// @throws InputError
  BenchmarkRunner(Experiment experiment, PlannerCatalogue catalogue, const std::string& folder,
                  EarlierRuns earlier = EarlierRuns::kRefuse);

  /// All runs that are not recorded yet, or those up to an interrupt (see interrupt.h); the run under way is
  /// then dropped.
  void run();

  /// What is going on and for how long still. Any thread may ask.
  std::string progress() const;

  /// What there is to do, in one line.
  std::string outlook() const;

  /// All runs in the folder, in the order they were made, earlier ones included.
  const std::vector<RunRecord>& records() const { return file_->records(); }
  std::size_t plannedRuns() const { return planned_; }
  bool anyFailedVerification() const;
  bool anyCrashed() const;
  bool anySolved() const;

  /// The tables of summary.md.
  std::string report() const;

 private:
  struct SceneRuns {
    ListedScene listed;
    std::unique_ptr<OmplLog> log;
  };
  struct Planned {
    std::size_t scene, contender;  ///< indices
    int number;                    ///< counted from 1
  };

  void checkInput();
  void openFolder(EarlierRuns earlier);
  std::vector<Planned> plan() const;
  RunLimits limitsOf(const Planned& run) const;
  QuerySettings settingsFor(const Planned& run) const;
  void runOne(const Planned& planned);
  ompl::tools::Benchmark::CompleteExperiment benchmark(BenchmarkRun& run, const std::string& name,
                                                       const RunLimits& limits) const;
  void writeLog(SceneRuns& runs) const;
  void writeSummary() const;
  std::string resultFile(const RunRecord& record) const;
  std::string header() const;
  void announce(const std::string& what);
  TimeLeft left() const;

  Experiment experiment_;
  PlannerCatalogue catalogue_;
  std::string folder_;
  std::vector<SceneRuns> scenes_;
  std::vector<Contender> recorded_contenders_;  ///< those of earlier runs in the folder included
  std::unique_ptr<RunFile> file_;
  std::size_t planned_ = 0;
  std::vector<Planned> to_do_;  ///< not recorded yet, the next one last

  mutable std::mutex progress_mutex_;
  std::string current_;
  std::size_t done_ = 0;
  TimeLeft left_;
  std::chrono::steady_clock::time_point current_start_;
};

}  // namespace b4p
