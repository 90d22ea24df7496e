// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/commands/progress_line.h"
#include "experiments/interrupt.h"
#include "experiments/runner/experiment.h"
#include "experiments/runner/runner.h"

namespace b4p {
namespace {

int bench(const std::string& file, const std::string& out) {
  const Experiment experiment = loadExperiment(file);
  BenchmarkRunner runner(experiment, PlannerCatalogue::standard(), out);
  catchInterrupts();
  {
    const ProgressLine progress([&runner] { return runner.progress(); });
    runner.run();
  }
  std::cout << runner.report() << "written to " << out << "\n";
  if (runner.anyFailedVerification()) return kNotVerified;
  return interrupted() ? kInterrupted : kSolved;
}

}  // namespace

void addBenchCommand(CLI::App& app, Run& run) {
  struct Options {
    std::string experiment;
    std::string out;
  };
  CLI::App* command = app.add_subcommand("bench",
                                         "Run an experiment and write OMPL benchmark logs, result files and "
                                         "a summary. Ctrl-C ends the run under way "
                                         "and keeps those before it");
  auto options = std::make_shared<Options>();
  command->add_option("EXPERIMENT", options->experiment, "Experiment file (YAML)")->required();
  command->add_option("--out", options->out, "Folder for what is written")->required();
  command->callback(
      [&run, options] { run = [options] { return bench(options->experiment, options->out); }; });
}

}  // namespace b4p
