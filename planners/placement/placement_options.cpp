// SPDX-License-Identifier: BSD-3-Clause
#include "planners/placement/placement_options.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace b4p {

std::string PlacementOptions::problem() const {
  if (!(exploration >= 0.0) || !std::isfinite(exploration))
    return "exploration has to be at least 0 and finite, not " + std::to_string(exploration);
  if (attempts == 0) return "attempts has to be at least 1";
  if (ik_attempts == 0) return "ik_attempts has to be at least 1";
  if (postures == 0) return "postures has to be at least 1";
  if (!(stage >= 0.0 && stage <= 1.0)) return "stage has to be from 0 to 1, not " + std::to_string(stage);
  if (!(discount > 0.0 && discount <= 1.0))
    return "discount has to be above 0 and at most 1, not " + std::to_string(discount);
  return {};
}

std::string PlacementStatistics::summary() const {
  std::vector<std::pair<std::uint64_t, std::string>> failures{{unstable, "not stable"},
                                                              {object_collides, "object collides"},
                                                              {not_better, "no better than before"},
                                                              {hand_collides, "hand collides"},
                                                              {unreachable, "out of reach"},
                                                              {arm_collides, "arm collides"}};
  std::stable_sort(failures.begin(), failures.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string text = std::to_string(valid) + " of " + std::to_string(draws) + " draws valid";
  for (const auto& [count, reason] : failures)
    if (count > 0) text += ", " + std::to_string(count) + " " + reason;
  if (exhausted > 0) text += "; no branch left that could be better";
  return text;
}

}  // namespace b4p
