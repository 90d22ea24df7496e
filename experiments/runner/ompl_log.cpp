// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/runner/ompl_log.h"

#include <algorithm>
#include <sstream>

#include "experiments/runner/build_info.h"

namespace b4p {

OmplLog::OmplLog(ompl::geometric::SimpleSetup& setup, const std::string& name, const std::string& header,
                 double time_limit_s, int runs, std::uint64_t seed)
    : Benchmark(setup, name) {
  exp_.maxTime = time_limit_s;
  exp_.maxMem = 0.0;
  exp_.runCount = static_cast<unsigned>(runs);
  exp_.startTime = ompl::time::now();
  exp_.totalDuration = 0.0;
  exp_.setupInfo = header;
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

void OmplLog::add(const std::string& label, const CompleteExperiment& recorded,
                  const RunProperties& own_columns) {
  exp_.host = recorded.host;
  exp_.cpuInfo = recorded.cpuInfo;
  exp_.maxMem = recorded.maxMem;
  exp_.totalDuration = ompl::time::seconds(ompl::time::now() - exp_.startTime);
  const PlannerExperiment& source = recorded.planners.at(0);
  PlannerExperiment& target = planner(label);
  target.common = source.common;
  RunProperties run;
  if (source.runs.empty())
    run["status ENUM"] = std::to_string(static_cast<int>(ompl::base::PlannerStatus::CRASH));
  else
    run = source.runs.front();
  for (const auto& [name, value] : own_columns) run[name] = value;
  target.runs.push_back(run);
  target.progressPropertyNames = source.progressPropertyNames;
  // OMPL lists the time even for planners without progress properties. Of the others, each run has its line,
  // be it empty.
  if (target.progressPropertyNames.size() > 1)
    target.runsProgressData.push_back(source.runsProgressData.empty() ? RunProgressData()
                                                                      : source.runsProgressData.front());
}

std::string OmplLog::text() const {
  std::ostringstream out;
  saveResultsToStream(out);
  // The first line names OMPL's version, which OMPL 1.5 leaves out.
  const std::string text = out.str();
  return "OMPL version " + omplVersion() + text.substr(text.find('\n'));
}

}  // namespace b4p
