// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/runner/runner.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>
#include <utility>

#include <ompl/util/Console.h>

#include "experiments/interrupt.h"
#include "experiments/output_file.h"
#include "experiments/preflight.h"
#include "experiments/runner/build_info.h"
#include "experiments/runner/summary.h"
#include "experiments/verification/verifier.h"
#include "robots/input_error.h"

namespace b4p {

namespace fs = std::filesystem;
using OmplBenchmark = ompl::tools::Benchmark;

namespace {

constexpr const char* kResultsFolder = "results";

QuerySettings settingsFor(const Experiment& experiment, const Contender& contender, int run) {
  QuerySettings settings;
  settings.planner = contender.planner;
  settings.parameters = contender.parameters;
  settings.threads = contender.threads;
  settings.seed = derivedSeed(experiment.seed, static_cast<std::uint64_t>(run));
  settings.time_limit_s = experiment.time_limit_s;
  return settings;
}

std::string number(double value) {
  if (!std::isfinite(value)) return "nan";
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << value;
  return text.str();
}

/// A planner's progress property by its name, "0" where it has none.
std::string property(const ompl::base::Planner& planner, const std::string& name) {
  const auto& properties = planner.getPlannerProgressProperties();
  const auto found = properties.find(name);
  return found == properties.end() ? "0" : found->second();
}

OmplBenchmark::RunProperties ownColumns(const Query& query, const PlanResult& result) {
  const bool verified = result.solved && result.verification.passed;
  OmplBenchmark::RunProperties columns;
  columns["grasp id INTEGER"] = std::to_string(result.grasp_id);
  for (const char* name : {"repairs tried INTEGER", "repairs succeeded INTEGER"})
    columns[name] = property(*query.planner(), name);
  columns["validity checks INTEGER"] = std::to_string(query.configurationsChecked());
  columns["edge checks INTEGER"] = std::to_string(query.edgeChecks());
  columns["verified BOOLEAN"] = verified ? "1" : "0";
  columns["seed INTEGER"] = std::to_string(result.seed);
  columns["threads INTEGER"] = std::to_string(result.threads);
  columns["time to verified path REAL"] =
      number(verified ? result.planning_time_s : std::numeric_limits<double>::quiet_NaN());
  return columns;
}

/// Files of that kind in a folder; none where there is no such folder.
std::vector<fs::path> filesIn(const fs::path& folder, const std::string& extension) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.is_regular_file() && entry.path().extension() == extension) files.push_back(entry.path());
  return files;
}

void clearFolder(const std::string& folder, bool overwrite) {
  std::vector<fs::path> earlier = filesIn(folder, ".log");
  for (const fs::path& file : filesIn(fs::path(folder) / kResultsFolder, ".json")) earlier.push_back(file);
  if (!earlier.empty() && !overwrite)
    throw InputError(folder, "",
                     "holds logs or results of an earlier experiment (" + earlier.front().string() +
                         "); take another folder or --overwrite");
  for (const fs::path& file : earlier) {
    std::error_code error;
    if (!fs::remove(file, error)) throw InputError(file.string(), "", "cannot be removed");
  }
}

}  // namespace

BenchmarkRunner::BenchmarkRunner(Experiment experiment, PlannerCatalogue catalogue, const std::string& folder,
                                 bool overwrite)
    : experiment_(std::move(experiment)), catalogue_(std::move(catalogue)), folder_(folder) {
  for (const std::string& given : experiment_.scenes) {
    scenes_.push_back({given, loadScene(given), nullptr});
    const std::string& name = scenes_.back().scene.name;
    if (std::count_if(scenes_.begin(), scenes_.end(),
                      [&name](const SceneRuns& s) { return s.scene.name == name; }) > 1)
      throw InputError(experiment_.file, "scenes", "two scenes are called '" + name + "'");
  }
  for (SceneRuns& runs : scenes_) {
    for (const Contender& contender : experiment_.contenders) {
      Query query(runs.scene, runs.given, catalogue_, settingsFor(experiment_, contender, 0),
                  experiment_.file + ": planners: " + contender.label);
    }
    preflight(runs.scene);
  }
  clearFolder(folder_, overwrite);
  requireWritableFolder(folder_);
  requireWritableFolder((fs::path(folder_) / kResultsFolder).string());
}

std::size_t BenchmarkRunner::plannedRuns() const {
  return scenes_.size() * experiment_.contenders.size() * static_cast<std::size_t>(experiment_.runs);
}

void BenchmarkRunner::run() {
  start_ = std::chrono::steady_clock::now();
  for (SceneRuns& runs : scenes_)
    for (int number = 1; number <= experiment_.runs; ++number)
      for (const Contender& contender : experiment_.contenders) {
        if (interrupted()) return;
        announce(runs.scene.name + " " + contender.label);
        runOne(runs, contender, number);
      }
}

void BenchmarkRunner::runOne(SceneRuns& runs, const Contender& contender, int number) {
  Query query(runs.scene, runs.given, catalogue_, settingsFor(experiment_, contender, number),
              experiment_.file);
  RunRecord record;
  record.scene = runs.scene.name;
  record.label = contender.label;
  record.run = number;
  const auto recorded = benchmark(query, runs.scene.name, record.result);
  if (interrupted() && !record.result.solved) return;
  record.crashed = crashed(record.result);
  if (record.crashed) record.crash = query.planner()->crash();

  if (!runs.log)
    runs.log = std::make_unique<OmplLog>(*query.problem().setup, runs.scene.name, header(),
                                         experiment_.time_limit_s, experiment_.runs, experiment_.seed);
  runs.log->add(contender.label, recorded, ownColumns(query, record.result));
  if (record.result.solved) writeResult(resultFile(record), record.result);
  writeFile((fs::path(folder_) / (runs.scene.name + ".log")).string(), runs.log->text());
  records_.push_back(std::move(record));
  writeSummary();
  const std::lock_guard<std::mutex> lock(progress_mutex_);
  done_ = records_.size();
}

OmplBenchmark::CompleteExperiment BenchmarkRunner::benchmark(Query& query, const std::string& name,
                                                             PlanResult& result) const {
  constexpr double kNoMemoryLimit_MB = 1e6;
  constexpr double kProgressSamples = 200.0;
  constexpr double kFinestProgress_s = 0.005;
  OmplBenchmark benchmark(*query.problem().setup, name);
  benchmark.addPlanner(query.planner());
  // OMPL's own limit is only a net below the exact one.
  OmplBenchmark::Request request(2.0 * experiment_.time_limit_s + 1.0, kNoMemoryLimit_MB, 1);
  request.timeBetweenUpdates = std::max(kFinestProgress_s, experiment_.time_limit_s / kProgressSamples);
  request.displayProgress = false;
  request.saveConsoleOutput = false;
  request.simplify = false;
  benchmark.setPostRunEvent([&](const ompl::base::PlannerPtr&, OmplBenchmark::RunProperties& properties) {
    const int status = std::stoi(properties.at("status ENUM"));
    result =
        query.result(ompl::base::PlannerStatus(static_cast<ompl::base::PlannerStatus::StatusType>(status)));
    if (result.solved) result.verification = verify(query.problem().scene, result);
  });
  benchmark.benchmark(request);
  ompl::msg::noOutputHandler();
  if (result.status.empty()) result = query.result(ompl::base::PlannerStatus::CRASH);
  return benchmark.getRecordedExperimentData();
}

std::string BenchmarkRunner::resultFile(const RunRecord& record) const {
  return (fs::path(folder_) / kResultsFolder /
          (record.scene + "-" + record.label + "-" + std::to_string(record.run) + ".json"))
      .string();
}

std::string BenchmarkRunner::header() const {
  std::ostringstream text;
  text << buildInfo() << "experiment: " << experiment_.name << "\n"
       << "time limit per run: " << experiment_.time_limit_s << " s\n"
       << "seed: " << experiment_.seed << "\n";
  for (const Contender& contender : experiment_.contenders) {
    text << contender.label << ": " << contender.planner << ", threads " << contender.threads;
    for (const auto& [name, value] : contender.parameters) text << ", " << name << " " << value;
    text << "\n";
  }
  text << "seeds of the runs:";
  for (int run = 1; run <= experiment_.runs; ++run)
    text << ' ' << derivedSeed(experiment_.seed, static_cast<std::uint64_t>(run));
  text << "\n";
  return text.str();
}

void BenchmarkRunner::announce(const std::string& what) {
  const std::lock_guard<std::mutex> lock(progress_mutex_);
  current_ = what;
}

std::string BenchmarkRunner::progress() const {
  const std::lock_guard<std::mutex> lock(progress_mutex_);
  const double elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const auto left = static_cast<double>(plannedRuns() - done_);
  std::ostringstream text;
  text << "run " << done_ + 1 << " of " << plannedRuns() << " (" << current_ << "), ";
  if (done_ > 0)
    text << "about " << std::lround(elapsed_s / static_cast<double>(done_) * left) << " s left";
  else
    text << "at most " << std::lround(left * experiment_.time_limit_s) << " s left";
  return text.str();
}

bool BenchmarkRunner::anyFailedVerification() const {
  return std::any_of(records_.begin(), records_.end(),
                     [](const RunRecord& r) { return r.result.solved && !r.verified(); });
}

bool BenchmarkRunner::anyCrashed() const {
  return std::any_of(records_.begin(), records_.end(), [](const RunRecord& r) { return r.crashed; });
}

bool BenchmarkRunner::anySolved() const {
  return std::any_of(records_.begin(), records_.end(), [](const RunRecord& r) { return r.result.solved; });
}

std::string BenchmarkRunner::report() const { return summaryTables(experiment_, records_); }

void BenchmarkRunner::writeSummary() const {
  std::ostringstream text;
  text << "# " << experiment_.name << "\n\n"
       << records_.size() << " of " << plannedRuns() << " planned runs recorded, at most "
       << experiment_.time_limit_s
       << " s each. Times run from the start of planning (drawing of start states included) to the path, for "
          "runs whose path was verified; all "
          "other runs count as longer than the limit.\n\n"
       << report() << "```\n"
       << header() << "```\n";
  writeFile((fs::path(folder_) / "summary.md").string(), text.str());
}

}  // namespace b4p
