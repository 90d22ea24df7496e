// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <iostream>
#include <memory>

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "experiments/certification/certificate.h"
#include "experiments/certification/digest.h"
#include "experiments/commands/commands.h"
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

/// What is known of a scene's task.
struct Account {
  const Scene& scene;

  std::string operator()(const PickPlaceTask&) const { return certified(scene); }
  std::string operator()(const ReachTask& task) const {
    const bool several = task.X_WT.size() != 1;
    return "reaching: " + std::to_string(task.X_WT.size()) +
           (task.orientation_free ? " position" : " grasp") + (several ? "s" : "");
  }
  std::string operator()(const PlacementTask& task) const {
    return "placement of " + task.object_name + ": " + std::to_string(task.arms.size()) +
           (task.arms.size() == 1 ? " arm" : " arms");
  }
};

void listScenes() {
  std::cout << "Scenes\n";
  for (const std::string& name : sceneNames()) {
    const Scene scene = loadScene(name);
    std::cout << "  " << name << ": robot " << scene.robot.file << ", budget " << scene.budget_s
              << " s, edge step " << scene.edge_step_m << " m\n    " << std::visit(Account{scene}, scene.task)
              << "\n";
  }
}

std::string tasksOf(const PlannerKind& kind) {
  std::string tasks;
  for (const TaskKind task : kind.tasks) tasks += (tasks.empty() ? "" : ", ") + nameOf(task);
  return tasks;
}

void listPlanners() {
  // Parameters belong to planner objects, so one of each is made, on a space that nothing is planned in.
  const auto si =
      std::make_shared<ompl::base::SpaceInformation>(std::make_shared<ompl::base::RealVectorStateSpace>(1));
  std::cout << "Planners (parameters: default, range; meaning)\n";
  const PlannerCatalogue catalogue = PlannerCatalogue::standard();
  for (const PlannerKind& kind : catalogue.kinds()) {
    std::cout << "  " << kind.name << " (" << tasksOf(kind) << "): " << kind.description << "\n";
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
                  listPlanners();
          return kSolved;
        };
      });
}

}  // namespace b4p
