// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "experiments/placement/placement_improvement.h"
#include "planners/placement/placement_options.h"

namespace b4p {

/// What a placement planner has found in a scene, as it is written to a file (JSON).
struct PlacementResult {
  std::string scene;      ///< name or path
  std::string objective;  ///< as scene files name it
  std::string sampling;
  std::map<std::string, std::string> parameters;
  std::uint64_t seed = 0;
  double time_limit_s = 0.0;
  double planning_time_s = 0.0;
  std::string status;  ///< OMPL's name of the planner status
  std::vector<std::string> arms;
  std::vector<std::vector<std::string>> joint_names;  ///< of each arm
  std::vector<PlacementImprovement> improvements;     ///< in the order they were found: the last is the best
  PlacementStatistics draws;
  std::string reason;  ///< why there is none; empty when there is one

  bool solved() const { return !improvements.empty(); }
  bool verified() const;
};

/// Writes UTF-8 JSON as writeFile() does, with the digits that read back to the same bits.
/// @throws InputError if the place cannot be written
void writePlacementResult(const std::string& file, const PlacementResult& result);

}  // namespace b4p
