// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <string>

#include <ompl/geometric/SimpleSetup.h>

#include "experiments/deadline_planner.h"
#include "experiments/planners.h"
#include "experiments/query.h"
#include "experiments/runner/listed_scene.h"
#include "experiments/runner/run_record.h"

namespace b4p {

/// One run of a benchmark, whatever its scene asks for: a planner that OMPL's Benchmark runs, and what comes
/// of it. A run lives alone in its process, as a Query does.
class BenchmarkRun {
 public:
  virtual ~BenchmarkRun() = default;

  virtual ompl::geometric::SimpleSetup& setup() const = 0;
  virtual const std::shared_ptr<DeadlinePlanner>& planner() const = 0;

  /// Takes what the planner has left and verifies it. Comes before all that follows.
  virtual void conclude(const ompl::base::PlannerStatus& status) = 0;

  /// Whether the planner came to its own end, so that an interrupt has cut nothing off.
  virtual bool finished() const = 0;

  /// Adds what came of the run to its record, OMPL's part left aside.
  virtual void fill(RunRecord& record) const = 0;

  /// Columns beside those of OMPL, "NAME TYPE" -> value.
  virtual std::map<std::string, std::string> columns() const = 0;

  /// Writes the result file of a run that has solved its scene.
  virtual void write(const std::string& file) const = 0;

 protected:
  BenchmarkRun() = default;
  BenchmarkRun(const BenchmarkRun&) = default;
  BenchmarkRun& operator=(const BenchmarkRun&) = default;
};

/// @param where  named in errors about planner and parameters
/// @throws InputError
std::unique_ptr<BenchmarkRun> makeBenchmarkRun(const ListedScene& listed, const PlannerCatalogue& catalogue,
                                               const QuerySettings& settings, const std::string& where);

/// Finds what may be wrong with the settings of such a run, as makeBenchmarkRun() does but sooner where the
/// scene takes long to prepare.
/// @throws InputError
void checkBenchmarkRun(const ListedScene& listed, const PlannerCatalogue& catalogue,
                       const QuerySettings& settings, const std::string& where);

}  // namespace b4p
