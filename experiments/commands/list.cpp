// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <iostream>
#include <memory>

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "experiments/certification/certificate.h"
#include "experiments/certification/digest.h"
#include "experiments/commands/commands.h"
#include "experiments/placement/placement_file.h"
#include "experiments/planners.h"
#include "experiments/scene.h"
#include "robots/input_error.h"

namespace b4p {
namespace {

/// What a scene's certificate says, or what is wrong with it.
std::string certified(const Scene& scene) {
  const std::string file = certificateFile(scene);
  if (!std::filesystem::exists(file)) return "no certificate";
  try {
    const Certificate certificate = readCertificate(file);
    if (certificate.digest != sceneDigest(scene)) return "certificate is out of date";
    const CertificateNumbers& n = certificate.numbers;
    return "certified: of " + std::to_string(n.sampled) + " grasps, " + std::to_string(n.valid_at_pick) +
           " are valid at the pick, " + std::to_string(n.with_placement) + " with a placement, " +
           std::to_string(n.compatible) + " compatible, " + std::to_string(n.blocked) + " proved blocked";
  } catch (const InputError& e) {
    return std::string("certificate is of no use: ") + e.what();
  }
}

void listScenes() {
  std::cout << "Scenes\n";
  for (const std::string& name : sceneNames()) {
    const Scene scene = loadScene(name);
    std::cout << "  " << name << ": robot " << scene.robot.file << ", budget " << scene.budget_s
              << " s, edge step " << scene.edge_step_m << " m\n    ";
    std::cout << certified(scene) << "\n";
  }
}

void listPlacementScenes() {
  std::cout << "Placement scenes\n";
  for (const std::string& name : placementSceneNames()) {
    const Scene scene = loadPlacementScene(name);
    std::cout << "  " << name << ": " << scene.object_name << ", arms " << scene.place->arms.size()
              << ", budget " << scene.budget_s << " s\n";
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
  app.add_subcommand("list", "Scenes with what is certified, planners with their parameters")
      ->callback([&run] {
        run = [] {
          listScenes();
          listPlacementScenes();
          listPlanners();
          return kSolved;
        };
      });
}

}  // namespace b4p
