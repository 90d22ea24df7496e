// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "experiments/commands/commands.h"
#include "experiments/planners.h"
#include "experiments/scene.h"

namespace b4p {
namespace {

void listScenes() {
  std::cout << "Scenes\n";
  for (const std::string& name : sceneNames()) {
    const Scene scene = loadScene(name);
    std::cout << "  " << name << ": robot " << scene.robot.file << ", budget " << scene.budget_s
              << " s, edge step " << scene.edge_step_m << " m\n    ";
    const SceneNumbers& n = scene.numbers;
    if (n.grasps_sampled > 0)
      std::cout << "stated: of " << n.grasps_sampled << " grasps sampled, " << n.grasps_valid_at_pick
                << " are valid at the pick and " << n.grasps_compatible << " compatible with a placement\n";
    else
      std::cout << "no numbers stated\n";
  }
}

void listPlanners() {
  // Parameters belong to planner objects, so one of each is made, on a space that nothing is planned in.
  const auto si =
      std::make_shared<ompl::base::SpaceInformation>(std::make_shared<ompl::base::RealVectorStateSpace>(1));
  std::cout << "Planners (parameters: default, range; meaning)\n";
  const PlannerCatalogue catalogue = PlannerCatalogue::standard();
  for (const PlannerKind& kind : catalogue.kinds()) {
    std::cout << "  " << kind.name << ": " << kind.description << "\n";
    const auto planner = kind.make(si);
    for (const auto& [name, parameter] : planner->params().getParams()) {
      std::cout << "    " << name << ": " << parameter->getValue();
      if (!parameter->getRangeSuggestion().empty()) std::cout << ", " << parameter->getRangeSuggestion();
      const std::string meaning = parameterMeaning(*planner, name);
      std::cout << (meaning.empty() ? "" : "; ") << meaning << "\n";
    }
  }
}

}  // namespace

void addListCommand(CLI::App& app, Run& run) {
  app.add_subcommand("list", "Scenes with their numbers, planners with their parameters")->callback([&run] {
    run = [] {
      listScenes();
      listPlanners();
      return kSolved;
    };
  });
}

}  // namespace b4p
