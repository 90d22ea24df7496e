// SPDX-License-Identifier: BSD-3-Clause
// placement_first [SEEDS [SECONDS [SCENE...]]]: how long the anytime planner takes to bring an object to its
// first placement (all placement scenes that ship). One line per scene, over SEEDS (5) seeds: processor time
// of planning, pre-processing left out, median and range, and how often each arm was the one. Runs that have
// found nothing after SECONDS (60) count as the longest.
#include <algorithm>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include "experiments/placement/placement_file.h"
#include "experiments/placement/placement_query.h"
#include "planners/processor_time.h"
#include "robots/input_error.h"

namespace b4p {
namespace {

void measure(const std::string& name, int seeds, double limit_s) {
  const Scene scene = loadPlacementScene(name);
  std::vector<double> times_s;
  std::vector<int> used(scene.placing().arms.size(), 0);
  for (int seed = 1; seed <= seeds; ++seed) {
    PlacementQuerySettings settings;
    settings.seed = static_cast<std::uint64_t>(seed);
    settings.time_limit_s = limit_s;
    PlacementQuery query(scene, name, settings, "placement_first");
    // Any placement is good enough.
    query.problem().pdef->getOptimizationObjective()->setCostThreshold(
        ompl::base::Cost(std::numeric_limits<double>::lowest()));
    const double begin = threadTime_s();
    const PlacementResult result = query.solve();
    times_s.push_back(result.solved() ? threadTime_s() - begin : std::numeric_limits<double>::infinity());
    if (result.solved()) ++used[static_cast<std::size_t>(result.improvements.front().arm)];
  }
  std::sort(times_s.begin(), times_s.end());
  std::cout << name << " | " << times_s[times_s.size() / 2] << " s (" << times_s.front() << " ... "
            << times_s.back() << ")";
  for (std::size_t i = 0; i < used.size(); ++i)
    std::cout << " | " << scene.placing().arms[i].name << ' ' << used[i];
  std::cout << std::endl;
}

int run(int argc, char** argv) {
  const int seeds = argc > 1 ? std::stoi(argv[1]) : 5;
  const double limit_s = argc > 2 ? std::stod(argv[2]) : 60.0;
  std::vector<std::string> scenes(argv + std::min(argc, 3), argv + argc);
  if (scenes.empty()) scenes = placementSceneNames();
  try {
    for (const std::string& scene : scenes) measure(scene, seeds, limit_s);
  } catch (const InputError& e) {
    std::cerr << "placement_first: " << e.what() << std::endl;
    return 2;
  }
  return 0;
}

}  // namespace
}  // namespace b4p

int main(int argc, char** argv) { return b4p::run(argc, argv); }
