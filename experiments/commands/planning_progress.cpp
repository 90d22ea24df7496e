// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/commands/planning_progress.h"

#include <chrono>
#include <sstream>

namespace b4p {

ProgressLine planningProgress(const ompl::base::Planner& planner, double time_limit_s) {
  const auto start = std::chrono::steady_clock::now();
  return ProgressLine([&planner, start, time_limit_s] {
    std::ostringstream line;
    line.precision(1);
    line << std::fixed << std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()
         << " of " << time_limit_s << " s";
    for (const auto& [name, value] : planner.getPlannerProgressProperties())
      line << ", " << name.substr(0, name.rfind(' ')) << ' ' << value();
    return line.str();
  });
}

}  // namespace b4p
