// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/runner/listed_scene.h"

#include <algorithm>

#include "experiments/placement/placement_query.h"
#include "robots/input_error.h"

namespace b4p {
namespace {

std::vector<Scene> perObjective(const Experiment& experiment, const Scene& scene) {
  if (experiment.objectives.empty()) return {scene};
  if (scene.kind() != TaskKind::kPlacement)
    throw InputError(
        experiment.file, "objectives",
        "are for tasks of placement alone; '" + scene.name + "' is one of " + nameOf(scene.kind()));
  std::vector<Scene> scenes;
  for (const ClearanceGoal objective : experiment.objectives) {
    scenes.push_back(scene);
    scenes.back().name += "-" + nameOf(objective);
    scenes.back().placing().objective = objective;
  }
  return scenes;
}

}  // namespace

std::vector<ListedScene> listedScenes(const Experiment& experiment) {
  std::vector<ListedScene> scenes;
  for (const std::string& given : experiment.scenes)
    for (const Scene& scene : perObjective(experiment, loadScene(given))) {
      if (std::any_of(scenes.begin(), scenes.end(),
                      [&scene](const ListedScene& other) { return other.scene.name == scene.name; }))
        throw InputError(experiment.file, "scenes", "two scenes are called '" + scene.name + "'");
      scenes.push_back({given, scene});
    }
  return scenes;
}

}  // namespace b4p
