// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/runner/summary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

namespace b4p {
namespace {

/// Of sorted values, linear between neighbours; infinite as soon as an infinite one takes part.
double quantile(const std::vector<double>& sorted, double fraction) {
  const double position = fraction * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const double weight = position - static_cast<double>(below);
  if (weight == 0.0) return sorted[below];
  return sorted[below] + weight * (sorted[below + 1] - sorted[below]);
}

std::string seconds(double value, double limit_s) {
  std::ostringstream text;
  text.precision(3);
  if (std::isfinite(value))
    text << value;
  else
    text << "> " << limit_s;
  return text.str();
}

/// Median over the runs that have a placement.
std::string bestObjective(const std::vector<const RunRecord*>& runs) {
  std::vector<double> best;
  for (const RunRecord* run : runs)
    if (run->verified()) best.push_back(run->placement->improvements.back().objective_m);
  if (best.empty()) return "-";
  std::sort(best.begin(), best.end());
  std::ostringstream text;
  text.precision(4);
  text << quantile(best, 0.5);
  return text.str();
}

std::string oneLine(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::string row(const Contender& contender, const std::vector<const RunRecord*>& runs) {
  const double limit_s = runs.front()->limits.time_s;
  std::vector<double> times;
  int solved = 0, verified = 0, crashed = 0;
  std::set<int> grasps;
  for (const RunRecord* run : runs) {
    solved += run->solved;
    verified += run->verified();
    crashed += run->crashed;
    if (run->verified()) grasps.insert(run->grasp_id);
    times.push_back(run->verified() ? run->time_s : std::numeric_limits<double>::infinity());
  }
  std::sort(times.begin(), times.end());
  std::ostringstream text;
  text << "| " << contender.label << " | " << contender.planner << " | " << contender.threads << " | "
       << solved << " of " << runs.size() << " | " << verified << " of " << solved << " | " << crashed
       << " | " << seconds(quantile(times, 0.5), limit_s) << " | "
       << seconds(quantile(times, 0.25), limit_s) + " ... " + seconds(quantile(times, 0.75), limit_s) << " | "
       << grasps.size() << " |";
  if (runs.front()->placement) text << " " << bestObjective(runs) << " |";
  text << "\n";
  return text.str();
}

}  // namespace

std::string summaryTables(const std::vector<Contender>& contenders, const std::vector<RunRecord>& records) {
  std::vector<std::string> scenes;
  for (const RunRecord& record : records)
    if (std::find(scenes.begin(), scenes.end(), record.scene) == scenes.end()) scenes.push_back(record.scene);
  std::ostringstream text;
  for (const std::string& scene : scenes) {
    const bool placing = std::any_of(records.begin(), records.end(), [&scene](const RunRecord& record) {
      return record.scene == scene && record.placement;
    });
    text << "## " << scene << "\n\n"
         << "| label | planner | threads | solved | verified | crashed | median (s) | quartiles (s) | grasps "
            "used |"
         << (placing ? " best objective, median (m) |" : "") << "\n|---|---|---|---|---|---|---|---|---|"
         << (placing ? "---|" : "") << "\n";
    for (const Contender& contender : contenders) {
      std::vector<const RunRecord*> runs;
      for (const RunRecord& record : records)
        if (record.scene == scene && record.label == contender.label) runs.push_back(&record);
      if (!runs.empty()) text << row(contender, runs);
    }
    text << "\n";
    for (const RunRecord& record : records)
      if (record.scene == scene && record.crashed)
        text << "Run " << record.run << " of " << record.label << " crashed: " << oneLine(record.crash)
             << "\n\n";
  }
  return text.str();
}

}  // namespace b4p
