// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iostream>
#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/commands/progress_line.h"
#include "experiments/commands/whole_number.h"
#include "experiments/interrupt.h"
#include "experiments/runner/experiment.h"
#include "experiments/runner/runner.h"
#include "robots/input_error.h"

namespace b4p {
namespace {

constexpr const char* kWhere = "b4p bench";

struct Options {
  std::string experiment;
  std::string out;
  std::string runs, seed;            ///< empty: as the experiment's file says
  std::vector<std::string> threads;  ///< likewise
  std::vector<std::string> scenes;   ///< empty: all
  std::string clock, checker;        ///< empty: as the experiment's file says
  double time_limit_s = 0.0;
  bool has_time_limit = false;
  bool overwrite = false;
  bool resume = false;
};

ExperimentOverrides overridesFrom(const Options& options) {
  ExperimentOverrides overrides;
  if (!options.runs.empty())
    overrides.runs = static_cast<int>(wholeNumber(options.runs, 1, kMostRuns, kWhere, "--runs"));
  if (!options.seed.empty()) overrides.seed = wholeNumber(options.seed, 0, kLargestSeed, kWhere, "--seed");
  for (const std::string& text : options.threads) {
    const auto count = static_cast<unsigned>(wholeNumber(text, 1, kMostThreads, kWhere, "--threads"));
    if (std::count(overrides.threads.begin(), overrides.threads.end(), count) > 0)
      throw InputError(kWhere, "--threads", "is given twice (" + text + ")");
    overrides.threads.push_back(count);
  }
  overrides.scenes = options.scenes;
  if (!options.clock.empty()) overrides.clock = runClock(options.clock, kWhere, "--clock");
  if (!options.checker.empty()) overrides.checker = checkerNamed(options.checker, kWhere, "--checker");
  if (options.has_time_limit) {
    requireTimeLimit(options.time_limit_s, kWhere, "--time-limit-s");
    overrides.time_limit_s = options.time_limit_s;
  }
  return overrides;
}

ExitCode outcome(const BenchmarkRunner& runner) {
  if (runner.anyCrashed()) return kInternalError;
  if (runner.anyFailedVerification()) return kNotVerified;
  if (interrupted()) return kInterrupted;
  return runner.anySolved() ? kSolved : kUnsolved;
}

int bench(const Options& options) {
  const Experiment experiment = loadExperiment(options.experiment, overridesFrom(options));
  if (options.overwrite && options.resume)
    throw InputError(kWhere, "--resume", "keeps what --overwrite removes; give one of them");
  const EarlierRuns earlier = options.resume      ? EarlierRuns::kResume
                              : options.overwrite ? EarlierRuns::kRemove
                                                  : EarlierRuns::kRefuse;
  BenchmarkRunner runner(experiment, PlannerCatalogue::standard(), options.out, earlier);
  std::cout << runner.outlook() << std::endl;
  catchInterrupts();
  {
    const ProgressLine progress([&runner] { return runner.progress(); });
    runner.run();
  }
  std::cout << runner.report() << "written to " << options.out << "\n";
  return outcome(runner);
}

}  // namespace

void addBenchCommand(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand(
      "bench",
      "Run an experiment and write OMPL benchmark logs, result files and a summary. Ctrl-C ends the run "
      "under way and keeps those before it; so does everything else that ends the program, and --resume goes "
      "on from there. Exit code: 4 if any run crashed, else 3 if any result failed its "
      "verification, else 130 if interrupted, else 1 if no run was solved, else 0");
  auto options = std::make_shared<Options>();
  command->add_option("EXPERIMENT", options->experiment, "Experiment file (YAML)")->required();
  command->add_option("--out", options->out, "Folder for what is written")->required();
  command->add_option("--runs", options->runs,
                      "Runs per scene and planner, of all planners [the file's runs]");
  command->add_option("--seed", options->seed, "Seed [the file's seed]");
  command
      ->add_option("--threads", options->threads,
                   "Thread counts, as 1,2,4, of planners that do not state their own [the file's threads]")
      ->delimiter(',');
  command
      ->add_option("--scenes", options->scenes,
                   "Some of the file's scenes, as maze,grocery or placement/*_wine_glass [all]")
      ->delimiter(',');
  command->add_option("--checker", options->checker,
                      "Collision checker of all planners, fast or fcl [the file's checker, or fast]");
  CLI::Option* limit = command->add_option("--time-limit-s", options->time_limit_s,
                                           "Time limit of a run in seconds [the file's time_limit_s]");
  command->add_option(
      "--clock", options->clock,
      "What times and time limits are read from: elapsed, or processor, for machines that have "
      "other work to do [the file's clock, or elapsed]");
  command->add_flag(
      "--overwrite", options->overwrite,
      "Remove *.log, results/*.json, runs.jsonl and experiment.json that the folder holds already");
  command->add_flag("--resume", options->resume,
                    "Keep the runs that the folder holds already, and do those that are missing");
  command->callback([&run, options, limit] {
    options->has_time_limit = limit->count() > 0;
    run = [options] { return bench(*options); };
  });
}

}  // namespace b4p
