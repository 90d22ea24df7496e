// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/commands/key_values.h"
#include "experiments/commands/planning_progress.h"
#include "experiments/commands/whole_number.h"
#include "experiments/forest_file.h"
#include "experiments/interrupt.h"
#include "experiments/output_file.h"
#include "experiments/preflight.h"
#include "experiments/query.h"
#include "experiments/scene_files/data_files.h"
#include "experiments/verification/verifier.h"

namespace b4p {
namespace {

constexpr const char* kWhere = "b4p plan";

struct Options {
  std::string scene;
  std::string planner = "b4p";
  std::string checker = "fast";
  std::vector<std::string> parameters;
  std::string seed = "1";
  std::string threads = "1";
  double time_limit_s = 0.0;
  bool has_time_limit = false;
  std::string out = "result.json";
  std::string forests;
};

QuerySettings settingsFrom(const Options& options, const Scene& scene) {
  QuerySettings settings;
  settings.planner = options.planner;
  settings.checker = checkerNamed(options.checker, kWhere, "--checker");
  settings.parameters = keyValues(options.parameters, kWhere);
  settings.seed = wholeNumber(options.seed, 0, kLargestSeed, kWhere, "--seed");
  settings.threads =
      static_cast<unsigned>(wholeNumber(options.threads, 1, kMostThreads, kWhere, "--threads"));
  settings.time_limit_s = options.has_time_limit ? options.time_limit_s : scene.budget_s;
  requireTimeLimit(settings.time_limit_s, kWhere, "--time-limit-s");
  return settings;
}

void report(const PlanResult& result, const std::string& file) {
  std::cout << result.scene << ": " << result.status << " after " << result.planning_time_s << " s with "
            << result.planner << ", seed " << result.seed << "\n";
  if (result.solved) {
    std::cout << "grasp " << result.grasp_id << ", " << result.path.size() << " way-points, ";
    if (result.verification.passed)
      std::cout << "verified at " << result.verification.configurations << " configurations\n";
    else
      std::cout << "NOT verified: " << result.verification.failure << "\n";
  }
  std::cout << "written to " << file << "\n";
}

int plan(const Options& options) {
  const Scene scene = loadScene(options.scene);
  const QuerySettings settings = settingsFrom(options, scene);
  const std::string scene_name = nameFromAnywhere(options.scene);
  Query query(scene, scene_name, PlannerCatalogue::standard(), settings, kWhere);
  requireWritableFile(options.out);
  if (!options.forests.empty()) requireWritableFile(options.forests);
  preflight(scene);

  catchInterrupts();
  {
    const ProgressLine progress = planningProgress(*query.planner(), settings.time_limit_s);
    query.solve();
  }
  PlanResult result = query.result();
  if (result.solved) result.verification = verify(scene, result);
  writeResult(options.out, result);
  if (!options.forests.empty()) writeForests(options.forests, scene_name, query.problem(), *query.planner());
  report(result, options.out);
  if (crashed(result)) {
    std::cerr << "b4p: " << settings.planner << " ended by an exception: " << query.planner()->crash()
              << std::endl;
    return kInternalError;
  }
  if (result.solved) return result.verification.passed ? kSolved : kNotVerified;
  return interrupted() ? kInterrupted : kUnsolved;
}

}  // namespace

void addPlanCommand(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("plan", "Solve a scene, verify the path and write it to a file");
  auto options = std::make_shared<Options>();
  command->add_option("SCENE", options->scene, "Name of a scene that ships with b4p, or path of a scene file")
      ->required();
  command->add_option("--planner", options->planner, "Planner, see `b4p list`")->capture_default_str();
  command
      ->add_option("--param", options->parameters,
                   "KEY=VALUE: a parameter of the planner, see `b4p list`; repeatable")
      ->allow_extra_args(false);
  command
      ->add_option("--checker", options->checker,
                   "Collision checker: fast (vectorised) or fcl; both give the same answers")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Seed; on one thread it determines the path")
      ->capture_default_str();
  command->add_option("--threads", options->threads, "Parallel workers, 1 to 64")->capture_default_str();
  CLI::Option* limit = command->add_option("--time-limit-s", options->time_limit_s,
                                           "Time limit in seconds, > 0 [the scene's budget_s]");
  command->add_option("--out", options->out, "Result file (JSON)")->capture_default_str();
  command->add_option("--forests", options->forests, "File for the planner's trees (JSON) [none]");
  command->callback([&run, options, limit] {
    options->has_time_limit = limit->count() > 0;
    run = [options] { return plan(*options); };
  });
}

}  // namespace b4p
