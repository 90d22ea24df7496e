// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iostream>
#include <memory>
#include <mutex>
#include <sstream>
#include <vector>

#include "experiments/commands/commands.h"
#include "experiments/commands/key_values.h"
#include "experiments/commands/progress_line.h"
#include "experiments/commands/whole_number.h"
#include "experiments/interrupt.h"
#include "experiments/preflight.h"
#include "experiments/query.h"
#include "experiments/scene_files/data_files.h"
#include "experiments/speedup/speed_file.h"
#include "experiments/speedup/speed_run.h"

namespace b4p {
namespace {

constexpr const char* kWhere = "b4p simulate";

struct Options {
  std::string scene;
  std::string planner = "b4p";
  std::vector<std::string> parameters;
  std::vector<std::string> workers{"1", "2", "4", "8", "16", "32"};
  std::string runs = "10";
  std::string seed = "1";
  double time_limit_s = 0.0;
  bool has_time_limit = false;
  bool real_threads = false;
  std::string out = "speedup.json";
};

SpeedStudy studyFrom(const Options& options, const Scene& scene) {
  SpeedStudy study;
  study.scene = nameFromAnywhere(options.scene);
  study.planner = options.planner;
  study.parameters = keyValues(options.parameters, kWhere);
  study.time_limit_s = options.has_time_limit ? options.time_limit_s : scene.budget_s;
  requireTimeLimit(study.time_limit_s, kWhere, "--time-limit-s");
  return study;
}

/// All seeds of a number of workers after another would leave an interrupted study without the last numbers.
std::vector<SpeedCase> casesFrom(const Options& options) {
  const std::uint64_t runs = wholeNumber(options.runs, 1, kMostRuns, kWhere, "--runs");
  const std::uint64_t seed = wholeNumber(options.seed, 0, kLargestSeed - runs, kWhere, "--seed");
  std::vector<SpeedCase> cases;
  for (std::uint64_t run = 0; run < runs; ++run)
    for (const std::string& workers : options.workers) {
      const SpeedCase one{options.real_threads,
                          static_cast<unsigned>(wholeNumber(workers, 1, kMostThreads, kWhere, "--workers")),
                          seed + run};
      if (std::find(cases.begin(), cases.end(), one) != cases.end())
        throw InputError(kWhere, "--workers", "names a number twice (" + workers + ")");
      cases.push_back(one);
    }
  return cases;
}

std::string nameOf(const SpeedCase& which) {
  return std::to_string(which.workers) + (which.real_threads ? " threads, seed " : " workers, seed ") +
         std::to_string(which.seed);
}

SpeedRun runShowingProgress(const Scene& scene, const SpeedStudy& study, const SpeedCase& which,
                            const std::string& position) {
  std::mutex mutex;
  const ompl::base::Planner* planner = nullptr;
  const ProgressLine progress([&] {
    std::ostringstream line;
    line << "run " << position << ": " << nameOf(which);
    const std::lock_guard<std::mutex> lock(mutex);
    if (planner == nullptr) return line.str();
    for (const auto& [name, value] : planner->getPlannerProgressProperties())
      line << ", " << name.substr(0, name.rfind(' ')) << ' ' << value();
    return line.str();
  });
  return makeSpeedRun(scene, study, which, kWhere, [&](const ompl::base::Planner* watched) {
    const std::lock_guard<std::mutex> lock(mutex);
    planner = watched;
  });
}

void report(const SpeedRun& run) {
  std::cout << nameOf(run.which) << ": " << (run.solved ? "solved" : "unsolved") << " after " << run.time_s
            << " s, " << run.work_s << " s of work in " << run.steps << " steps";
  if (run.solved) std::cout << (run.verified ? ", verified" : ", NOT verified");
  std::cout << std::endl;
}

ExitCode outcome(const std::vector<SpeedRun>& runs) {
  const auto any = [&runs](const auto& holds) { return std::any_of(runs.begin(), runs.end(), holds); };
  if (any([](const SpeedRun& run) { return run.solved && !run.verified; })) return kNotVerified;
  if (interrupted()) return kInterrupted;
  return any([](const SpeedRun& run) { return run.solved; }) ? kSolved : kUnsolved;
}

int simulate(const Options& options) {
  const Scene scene = loadScene(options.scene);
  scene.pickPlace();  // nothing else is simulated
  const SpeedStudy study = studyFrom(options, scene);
  const std::vector<SpeedCase> cases = casesFrom(options);
  SpeedFile file(options.out, study);
  preflight(scene);

  catchInterrupts();
  std::size_t position = 0;
  for (const SpeedCase& which : cases) {
    ++position;
    if (file.has(which)) continue;
    const SpeedRun run = runShowingProgress(scene, study, which,
                                            std::to_string(position) + " of " + std::to_string(cases.size()));
    if (interrupted() && !run.solved) break;
    file.add(run);
    report(run);
  }
  std::cout << file.runs().size() << " runs in " << options.out << "\n";
  return outcome(file.runs());
}

}  // namespace

void addSimulateCommand(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand(
      "simulate",
      "Measure how the time to a solution falls with the number of B4P's workers, beyond the cores at hand: "
      "workers run in logical time on one core (docs/speedup.md). Runs that --out holds already are not "
      "repeated. Ctrl-C ends the run under way and keeps those before it. Exit code: 3 if any result failed "
      "its verification, else 130 if interrupted, else 1 if no run was solved, else 0");
  auto options = std::make_shared<Options>();
  command->add_option("SCENE", options->scene, "Name of a scene that ships with b4p, or path of a scene file")
      ->required();
  command->add_option("--planner", options->planner, "b4p or b4p-paper")->capture_default_str();
  command
      ->add_option("--param", options->parameters,
                   "KEY=VALUE: a parameter of the planner, see `b4p list`; repeatable")
      ->allow_extra_args(false);
  command->add_option("--workers", options->workers, "Numbers of workers, each 1 to 64, separated by commas")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  command->add_option("--runs", options->runs, "Runs per number of workers, with seeds from --seed on")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Seed of the first run")->capture_default_str();
  CLI::Option* limit = command->add_option("--time-limit-s", options->time_limit_s,
                                           "Limit of a run in seconds, logical ones [the scene's budget_s]");
  command->add_flag("--real-threads", options->real_threads,
                    "Run the workers in threads and measure elapsed time instead");
  command->add_option("--out", options->out, "File of runs (JSON lines)")->capture_default_str();
  command->callback([&run, options, limit] {
    options->has_time_limit = limit->count() > 0;
    run = [options] { return simulate(*options); };
  });
}

}  // namespace b4p
