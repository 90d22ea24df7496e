// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/runner/time_left.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace b4p {

TimeLeft timeLeft(const std::vector<RunToDo>& to_do, const std::vector<RunRecord>& done) {
  struct Sum {
    double seconds = 0.0;
    int runs = 0;
  };
  std::map<std::pair<std::string, std::string>, Sum> so_far;
  for (const RunRecord& record : done) {
    Sum& sum = so_far[{record.scene, record.label}];
    sum.seconds += record.wall_s;
    ++sum.runs;
  }
  TimeLeft left;
  for (const RunToDo& run : to_do) {
    const auto own = so_far.find({run.scene, run.label});
    left.about_s += own == so_far.end() ? run.limits.time_s : own->second.seconds / own->second.runs;
    left.at_most_s += run.limits.longest_s();
  }
  left.about_s = std::min(left.about_s, left.at_most_s);
  return left;
}

std::string durationText(double seconds) {
  constexpr long kMinute_s = 60, kHour_min = 60;
  constexpr double kMinutesFrom_s = 120.0;
  if (seconds < kMinutesFrom_s) return std::to_string(std::lround(std::max(0.0, seconds))) + " s";
  const long minutes = std::lround(seconds / kMinute_s);
  if (minutes < 2 * kHour_min) return std::to_string(minutes) + " min";
  return std::to_string(minutes / kHour_min) + " h " + std::to_string(minutes % kHour_min) + " min";
}

}  // namespace b4p
