// SPDX-License-Identifier: BSD-3-Clause
#include "planners/baselines/parameters.h"

#include <cmath>

namespace b4p {

std::string BaselineParameters::problem() const {
  constexpr unsigned kMostThreads = 64;
  if (threads < 1 || threads > kMostThreads)
    return "threads must be 1 ... " + std::to_string(kMostThreads) + " (" + std::to_string(threads) + ")";
  if (!(range >= 0.0) || !std::isfinite(range))
    return "range must be finite and >= 0 (" + std::to_string(range) + ")";
  if (placement_attempts < 1) return "placement_attempts must be at least 1 (0)";
  return "";
}

std::string RRTSharedParameters::problem() const {
  constexpr double kLongest_s = 1e6;
  if (!(restart_s > 0.0 && restart_s <= kLongest_s))
    return "restart_s must be > 0 and at most 1e6 s (" + std::to_string(restart_s) + ")";
  return BaselineParameters::problem();
}

std::string RRTRestartParameters::problem() const {
  constexpr double kFastest = 10.0;
  if (slice < 1) return "slice must be at least 1 (0)";
  if (!(growth >= 1.0 && growth <= kFastest))
    return "growth must be 1 ... 10 (" + std::to_string(growth) + ")";
  if (root_attempts < 1) return "root_attempts must be at least 1 (0)";
  return BaselineParameters::problem();
}

}  // namespace b4p
