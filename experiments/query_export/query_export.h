// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "experiments/json_value.h"
#include "experiments/scene.h"

namespace b4p {

/// How much of a scene of pick and place is drawn for others.
struct QueryExportSettings {
  int grasps = 100;  ///< where they form a continuum; finite families are taken whole
  int placements = 20;
  int place_roots = 1000;  ///< at most
  std::uint64_t seed = 1;
};

/// A scene as data that any planner can take up (docs/files.md).
struct ExportedQuery {
  Json document;
  std::string summary;  ///< one line on what is in it
  std::string failure;  ///< the first root that failed its verification, or ""
};

/// @throws InputError for a placement scene
void requireExportable(const Scene& scene);

/// @throws InputError for a placement scene, and when the robot's files are at fault
ExportedQuery exportQuery(const Scene& scene, const QueryExportSettings& settings);

}  // namespace b4p
