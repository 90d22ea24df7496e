// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/parameters.h"

#include <cmath>

namespace b4p {

std::string B4PParameters::problem() const {
  constexpr unsigned kMostThreads = 64;
  if (threads < 1 || threads > kMostThreads)
    return "threads must be 1 ... " + std::to_string(kMostThreads) + " (" + std::to_string(threads) + ")";
  if (pick_roots < 1) return "pick_roots must be at least 1 (0)";
  if (place_roots < 1) return "place_roots must be at least 1 (0)";
  if (!(range >= 0.0) || !std::isfinite(range))
    return "range must be finite and >= 0 (" + std::to_string(range) + ")";
  if (slice < 1) return "slice must be at least 1 (0)";
  if (root_attempts < 1) return "root_attempts must be at least 1 (0)";
  if (repair_iterations < 1) return "repair_iterations must be at least 1 (0)";
  return "";
}

}  // namespace b4p
