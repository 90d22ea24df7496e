// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/runner/ompl_log.h"

#include <algorithm>
#include <sstream>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/tools/benchmark/MachineSpecs.h>

#include "experiments/runner/build_info.h"

namespace b4p {

namespace {

/// OMPL wants one for every log; nothing is planned with it.
ompl::geometric::SimpleSetup& anySetup() {
  static ompl::geometric::SimpleSetup setup(std::make_shared<ompl::base::RealVectorStateSpace>(1));
  return setup;
}

}  // namespace

OmplRun omplRun(const ompl::tools::Benchmark::CompleteExperiment& recorded,
                const std::map<std::string, std::string>& own_columns) {
  const auto& source = recorded.planners.at(0);
  OmplRun run;
  run.common = source.common;
  if (source.runs.empty())
    run.columns["status ENUM"] = std::to_string(static_cast<int>(ompl::base::PlannerStatus::CRASH));
  else
    run.columns = source.runs.front();
  for (const auto& [name, value] : own_columns) run.columns[name] = value;
  // OMPL lists the time even for planners without progress properties.
  if (source.progressPropertyNames.size() <= 1) return run;
  run.progress_names = source.progressPropertyNames;
  if (!source.runsProgressData.empty()) run.progress = source.runsProgressData.front();
  return run;
}

OmplLog::OmplLog(const std::string& name, const std::string& header, double time_limit_s, int runs,
                 std::uint64_t seed)
    : Benchmark(anySetup(), name) {
  exp_.maxTime = time_limit_s;
  exp_.maxMem = kNoMemoryLimit_MB;
  exp_.runCount = static_cast<unsigned>(runs);
  exp_.startTime = ompl::time::now();
  exp_.totalDuration = 0.0;
  exp_.setupInfo = header;
  exp_.host = ompl::machine::getHostname();
  exp_.cpuInfo = ompl::machine::getCPUInfo();
  exp_.seed = static_cast<std::uint_fast32_t>(seed);
}

OmplLog::PlannerExperiment& OmplLog::planner(const std::string& label) {
  const auto found = std::find_if(exp_.planners.begin(), exp_.planners.end(),
                                  [&label](const PlannerExperiment& p) { return p.name == label; });
  if (found != exp_.planners.end()) return *found;
  exp_.planners.emplace_back();
  exp_.planners.back().name = label;
  return exp_.planners.back();
}

void OmplLog::add(const RunRecord& record) {
  exp_.totalDuration += record.wall_s;
  PlannerExperiment& target = planner(record.label);
  target.common = record.ompl.common;
  target.runs.push_back(record.ompl.columns);
  if (!record.ompl.progress_names.empty()) target.progressPropertyNames = record.ompl.progress_names;
  // Each run has its line, be it empty.
  target.runsProgressData.push_back(record.ompl.progress);
}

std::string OmplLog::text() {
  for (PlannerExperiment& planner : exp_.planners)
    if (planner.progressPropertyNames.empty()) planner.runsProgressData.clear();
  std::ostringstream out;
  saveResultsToStream(out);
  // The first line names OMPL's version, which OMPL 1.5 leaves out.
  const std::string text = out.str();
  return "OMPL version " + omplVersion() + text.substr(text.find('\n'));
}

}  // namespace b4p
