// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/commands/key_values.h"
#include "experiments/commands/planning_progress.h"
#include "experiments/commands/whole_number.h"
#include "experiments/interrupt.h"
#include "experiments/output_file.h"
#include "experiments/placement/placement_check.h"
#include "experiments/placement/placement_file.h"
#include "experiments/placement/placement_query.h"
#include "experiments/query.h"
#include "experiments/scene_files/data_files.h"
#include "robots/input_error.h"

namespace b4p {
namespace {

constexpr const char* kWhere = "b4p place";

struct Options {
  std::string scene;
  std::string objective;
  std::string sampling;
  std::vector<std::string> parameters;
  std::string seed = "1";
  double time_limit_s = 0.0;
  bool has_time_limit = false;
  std::string out = "result.json";
};

PlacementQuerySettings settingsFrom(const Options& options, const Scene& scene) {
  PlacementQuerySettings settings;
  if (!options.objective.empty())
    settings.objective = clearanceGoal(options.objective, kWhere, "--objective");
  settings.parameters = keyValues(options.parameters, kWhere);
  if (!options.sampling.empty()) {
    settings.options.sampling = placementSampling(options.sampling, kWhere);
    if (settings.parameters.count("sampling") > 0)
      throw InputError(kWhere, "--sampling", "is given by --param as well");
  }
  settings.seed = wholeNumber(options.seed, 0, kLargestSeed, kWhere, "--seed");
  settings.time_limit_s = options.has_time_limit ? options.time_limit_s : scene.budget_s;
  requireTimeLimit(settings.time_limit_s, kWhere, "--time-limit-s");
  return settings;
}

void report(const PlacementResult& result, const std::string& file) {
  std::cout << result.scene << ", " << result.objective << ": " << result.status << " after "
            << result.planning_time_s << " s, seed " << result.seed << "\n";
  for (const PlacementImprovement& improvement : result.improvements) {
    const PlacementVerification& verification = improvement.verification;
    std::cout << "  " << improvement.time_s << " s: objective " << improvement.objective_m << " m, arm "
              << result.arms[static_cast<std::size_t>(improvement.arm)] << ", " << improvement.path.size()
              << " way-points, ";
    if (verification.passed)
      std::cout << "verified at " << verification.configurations << " configurations\n";
    else
      std::cout << "NOT verified: " << verification.failure << "\n";
  }
  if (!result.solved()) std::cout << "no placement: " << result.reason << "\n";
  std::cout << "written to " << file << "\n";
}

int place(const Options& options) {
  const Scene scene = loadPlacementScene(options.scene);
  const PlacementQuerySettings settings = settingsFrom(options, scene);
  const std::string scene_name = nameFromAnywhere(options.scene);
  PlacementQuery query(scene, scene_name, settings, kWhere);
  requireWritableFile(options.out);

  catchInterrupts();
  PlacementResult result = [&] {
    const ProgressLine progress = planningProgress(*query.planner(), settings.time_limit_s);
    return query.solve();
  }();
  verifyImprovements(scene, result);
  writePlacementResult(options.out, result);
  report(result, options.out);
  if (!query.planner()->crash().empty()) {
    std::cerr << "b4p: placing ended by an exception: " << query.planner()->crash() << std::endl;
    return kInternalError;
  }
  if (result.solved()) return result.verified() ? kSolved : kNotVerified;
  return interrupted() ? kInterrupted : kUnsolved;
}

}  // namespace

void addPlaceCommand(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand(
      "place", "Find ever better placements in a placement scene, verify them and write them to a file");
  auto options = std::make_shared<Options>();
  command->add_option("SCENE", options->scene, "Placement scene: a name, or a path to a YAML file")
      ->required();
  command->add_option("--objective", options->objective,
                      "max_clearance or min_clearance [the scene's objective]");
  command->add_option(
      "--sampling", options->sampling,
      "How placements are drawn: tree (Monte Carlo tree search), children or area (uniform) [tree]");
  command
      ->add_option("--param", options->parameters,
                   "KEY=VALUE: a parameter of the planner `placement`, see `b4p list`; repeatable")
      ->allow_extra_args(false);
  command->add_option("--seed", options->seed, "Seed; it determines the placements but for their times")
      ->capture_default_str();
  CLI::Option* limit = command->add_option("--time-limit-s", options->time_limit_s,
                                           "Time limit in seconds, > 0 [the scene's budget_s]");
  command->add_option("--out", options->out, "Result file (JSON)")->capture_default_str();
  command->callback([&run, options, limit] {
    options->has_time_limit = limit->count() > 0;
    run = [options] { return place(*options); };
  });
}

}  // namespace b4p
