// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/runner/benchmark_run.h"

#include "experiments/runner/path_run.h"
#include "experiments/runner/placement_run.h"

namespace b4p {

std::unique_ptr<BenchmarkRun> makeBenchmarkRun(const ListedScene& listed, const PlannerCatalogue& catalogue,
                                               const QuerySettings& settings, const std::string& where) {
  if (listed.scene.kind() == TaskKind::kPlacement)
    return std::make_unique<PlacementRun>(listed, catalogue, settings, where);
  return std::make_unique<PathRun>(listed, catalogue, settings, where);
}

void checkBenchmarkRun(const ListedScene& listed, const PlannerCatalogue& catalogue,
                       const QuerySettings& settings, const std::string& where) {
  if (listed.scene.kind() == TaskKind::kPlacement)
    PlacementRun::check(listed, catalogue, settings, where);
  else
    makeBenchmarkRun(listed, catalogue, settings, where);
}

}  // namespace b4p
