// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/runner/runner.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>
#include <utility>

#include <ompl/util/Console.h>

#include "experiments/interrupt.h"
#include "experiments/output_file.h"
#include "experiments/preflight.h"
#include "experiments/runner/benchmark_run.h"
#include "experiments/runner/build_info.h"
#include "experiments/runner/summary.h"
#include "robots/input_error.h"

namespace b4p {

namespace fs = std::filesystem;
using OmplBenchmark = ompl::tools::Benchmark;

namespace {

constexpr const char* kResultsFolder = "results";
constexpr const char* kRunFile = "runs.jsonl";
constexpr const char* kSettingsFile = "experiment.json";

/// Files of that kind in a folder; none where there is no such folder.
std::vector<fs::path> filesIn(const fs::path& folder, const std::string& extension) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.is_regular_file() && entry.path().extension() == extension) files.push_back(entry.path());
  return files;
}

std::vector<fs::path> earlierFiles(const fs::path& folder) {
  std::vector<fs::path> earlier = filesIn(folder, ".log");
  for (const fs::path& file : filesIn(folder / kResultsFolder, ".json")) earlier.push_back(file);
  for (const char* name : {kRunFile, kSettingsFile})
    if (fs::exists(folder / name)) earlier.push_back(folder / name);
  return earlier;
}

void requireNoMixing(const fs::path& folder, EarlierRuns earlier) {
  const std::vector<fs::path> files = earlierFiles(folder);
  if (files.empty() || earlier == EarlierRuns::kRemove) return;
  if (earlier == EarlierRuns::kRefuse)
    throw InputError(folder.string(), "",
                     "holds logs or results of an earlier experiment (" + files.front().string() +
                         "); take another folder, --resume or --overwrite");
  if (!fs::exists(folder / kSettingsFile))
    throw InputError(folder.string(), "",
                     std::string("holds logs or results but no ") + kSettingsFile + ", so cannot be resumed");
}

}  // namespace

BenchmarkRunner::BenchmarkRunner(Experiment experiment, PlannerCatalogue catalogue, const std::string& folder,
                                 EarlierRuns earlier)
    : experiment_(std::move(experiment)), catalogue_(std::move(catalogue)), folder_(folder) {
  checkInput();
  openFolder(earlier);
  std::vector<Planned> planned = plan();
  planned_ = planned.size();
  for (auto run = planned.rbegin(); run != planned.rend(); ++run)
    if (file_->find(scenes_[run->scene].listed.scene.name, experiment_.contenders[run->contender].label,
                    run->number) == nullptr)
      to_do_.push_back(*run);
  for (SceneRuns& runs : scenes_) {
    const std::string& name = runs.listed.scene.name;
    runs.log = std::make_unique<OmplLog>(name, header(),
                                         experiment_.time_limit_s.value_or(runs.listed.scene.budget_s),
                                         experiment_.runs, experiment_.seed);
    for (const RunRecord& record : records())
      if (record.scene == name) runs.log->add(record);
  }
  done_ = planned_ - to_do_.size();
  left_ = left();
}

void BenchmarkRunner::checkInput() {
  for (ListedScene& listed : listedScenes(experiment_)) scenes_.push_back({std::move(listed), nullptr});
  for (std::size_t scene = 0; scene < scenes_.size(); ++scene) {
    const ListedScene& listed = scenes_[scene].listed;
    for (std::size_t i = 0; i < experiment_.contenders.size(); ++i)
      checkBenchmarkRun(listed, catalogue_, settingsFor({scene, i, 0}),
                        experiment_.file + ": planners: " + experiment_.contenders[i].label);
    preflight(listed.scene);
  }
}

void BenchmarkRunner::openFolder(EarlierRuns earlier) {
  const fs::path folder(folder_);
  requireNoMixing(folder, earlier);
  if (earlier == EarlierRuns::kRemove)
    for (const fs::path& file : earlierFiles(folder)) {
      std::error_code error;
      if (!fs::remove(file, error)) throw InputError(file.string(), "", "cannot be removed");
    }
  requireWritableFolder(folder_);
  requireWritableFolder((folder / kResultsFolder).string());
  std::vector<ListedScene> listed;
  for (const SceneRuns& runs : scenes_) listed.push_back(runs.listed);
  recorded_contenders_ = reconcileSettings((folder / kSettingsFile).string(), experiment_, listed);
  file_ = std::make_unique<RunFile>((folder / kRunFile).string());
}

std::vector<BenchmarkRunner::Planned> BenchmarkRunner::plan() const {
  int most_runs = 0;
  for (const Contender& contender : experiment_.contenders)
    most_runs = std::max(most_runs, experiment_.runsOf(contender));
  std::vector<Planned> planned;
  for (int number = 1; number <= most_runs; ++number)
    for (std::size_t scene = 0; scene < scenes_.size(); ++scene)
      for (std::size_t i = 0; i < experiment_.contenders.size(); ++i)
        if (number <= experiment_.runsOf(experiment_.contenders[i])) planned.push_back({scene, i, number});
  return planned;
}

RunLimits BenchmarkRunner::limitsOf(const Planned& run) const {
  const ListedScene& listed = scenes_[run.scene].listed;
  return experiment_.limitsFor(experiment_.contenders[run.contender], listed.given, listed.scene);
}

QuerySettings BenchmarkRunner::settingsFor(const Planned& run) const {
  const Contender& contender = experiment_.contenders[run.contender];
  const RunLimits limits = limitsOf(run);
  QuerySettings settings;
  settings.planner = contender.planner;
  settings.checker = contender.checker;
  settings.parameters = contender.parametersFor(scenes_[run.scene].listed.given);
  settings.threads = contender.threads;
  settings.seed = derivedSeed(experiment_.seed, static_cast<std::uint64_t>(run.number));
  settings.time_limit_s = limits.time_s;
  settings.check_limit = limits.checks;
  settings.stop = limits.stop;
  settings.clock = limits.clock;
  return settings;
}

void BenchmarkRunner::run() {
  while (!to_do_.empty() && !interrupted()) {
    const Planned next = to_do_.back();
    announce(scenes_[next.scene].listed.scene.name + " " + experiment_.contenders[next.contender].label);
    runOne(next);
  }
  for (SceneRuns& runs : scenes_) writeLog(runs);
  writeSummary();
}

void BenchmarkRunner::runOne(const Planned& planned) {
  const auto start = std::chrono::steady_clock::now();
  SceneRuns& runs = scenes_[planned.scene];
  const auto run = makeBenchmarkRun(runs.listed, catalogue_, settingsFor(planned), experiment_.file);
  RunRecord record;
  record.limits = limitsOf(planned);
  const auto recorded = benchmark(*run, runs.listed.scene.name, record.limits);
  if (interrupted() && !run->finished()) return;

  record.scene = runs.listed.scene.name;
  record.label = experiment_.contenders[planned.contender].label;
  record.run = planned.number;
  record.build = buildInfo();
  run->fill(record);
  record.ompl = omplRun(recorded, run->columns());
  if (record.solved) run->write(resultFile(record));
  record.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  file_->append(record);
  runs.log->add(record);
  to_do_.pop_back();
  {
    const std::lock_guard<std::mutex> lock(progress_mutex_);
    ++done_;
    left_ = left();
  }
  writeLog(runs);
  writeSummary();
}

OmplBenchmark::CompleteExperiment BenchmarkRunner::benchmark(BenchmarkRun& run, const std::string& name,
                                                             const RunLimits& limits) const {
  constexpr double kProgressSamples = 200.0;
  constexpr double kFinestProgress_s = 0.005;
  constexpr double kSlowestProcessor = 1000.0;  ///< elapsed time over processor time on a busy machine
  OmplBenchmark benchmark(run.setup(), name);
  benchmark.addPlanner(run.planner());
  // OMPL's own limit is only a net below the exact ones.
  const double late = limits.clock == RunClock::kProcessor ? kSlowestProcessor : 2.0;
  OmplBenchmark::Request request(late * limits.longest_s() + 1.0, kNoMemoryLimit_MB, 1);
  request.timeBetweenUpdates = std::max(kFinestProgress_s, limits.time_s / kProgressSamples);
  request.displayProgress = false;
  request.saveConsoleOutput = false;
  request.simplify = false;
  bool concluded = false;
  benchmark.setPostRunEvent([&](const ompl::base::PlannerPtr&, OmplBenchmark::RunProperties& properties) {
    const int status = std::stoi(properties.at("status ENUM"));
    run.conclude(ompl::base::PlannerStatus(static_cast<ompl::base::PlannerStatus::StatusType>(status)));
    concluded = true;
  });
  benchmark.benchmark(request);
  ompl::msg::noOutputHandler();
  if (!concluded) run.conclude(ompl::base::PlannerStatus::CRASH);
  return benchmark.getRecordedExperimentData();
}

void BenchmarkRunner::writeLog(SceneRuns& runs) const {
  if (runs.log->empty()) return;
  writeFile((fs::path(folder_) / (runs.listed.scene.name + ".log")).string(), runs.log->text());
}

std::string BenchmarkRunner::resultFile(const RunRecord& record) const {
  return (fs::path(folder_) / kResultsFolder /
          (record.scene + "-" + record.label + "-" + std::to_string(record.run) + ".json"))
      .string();
}

std::string BenchmarkRunner::header() const {
  std::ostringstream text;
  for (const auto& [key, value] : buildInfo()) text << key << ": " << value << "\n";
  text << "experiment: " << experiment_.name << "\n";
  if (experiment_.time_limit_s)
    text << "time limit per run: " << *experiment_.time_limit_s << " s\n";
  else
    for (const SceneRuns& runs : scenes_)
      text << "time limit per run on " << runs.listed.scene.name << ": " << runs.listed.scene.budget_s
           << " s\n";
  if (experiment_.check_cost_us)
    text << "check limit per run: the time limit x threads / " << *experiment_.check_cost_us << " us\n";
  for (const auto& [scene, checks] : experiment_.check_limits)
    text << "check limit per run on " << scene << ": " << checks << "\n";
  if (experiment_.check_cost_us || !experiment_.check_limits.empty())
    text << "a run ends when it has reached " << (experiment_.stop == StopRule::kBoth ? "both" : "one")
         << " of its limits\n";
  text << "clock: " << nameOf(experiment_.clock) << " time\nseed: " << experiment_.seed << "\n";
  int most_runs = 0;
  for (const Contender& contender : recorded_contenders_) {
    most_runs = std::max(most_runs, contender.runs);
    text << contender.label << ": " << contender.planner << ", checker " << checkerName(contender.checker)
         << ", threads " << contender.threads;
    for (const auto& [name, value] : contender.parameters) text << ", " << name << " " << value;
    for (const auto& [scene, parameters] : contender.scene_parameters)
      for (const auto& [name, value] : parameters) text << ", " << name << " " << value << " on " << scene;
    text << "\n";
  }
  text << "seeds of the runs:";
  for (int run = 1; run <= most_runs; ++run)
    text << ' ' << derivedSeed(experiment_.seed, static_cast<std::uint64_t>(run));
  text << "\n";
  return text.str();
}

void BenchmarkRunner::announce(const std::string& what) {
  const std::lock_guard<std::mutex> lock(progress_mutex_);
  current_ = what;
  current_start_ = std::chrono::steady_clock::now();
}

TimeLeft BenchmarkRunner::left() const {
  std::vector<RunToDo> to_do;
  for (const Planned& run : to_do_)
    to_do.push_back(
        {scenes_[run.scene].listed.scene.name, experiment_.contenders[run.contender].label, limitsOf(run)});
  return timeLeft(to_do, records());
}

std::string BenchmarkRunner::progress() const {
  const std::lock_guard<std::mutex> lock(progress_mutex_);
  const double elapsed_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - current_start_).count();
  std::ostringstream text;
  text << "run " << done_ + 1 << " of " << planned_ << " (" << current_ << "), about "
       << durationText(left_.about_s - elapsed_s) << " left, at most "
       << durationText(left_.at_most_s - elapsed_s);
  return text.str();
}

std::string BenchmarkRunner::outlook() const {
  std::ostringstream text;
  text << done_ << " of " << planned_ << " planned runs recorded";
  if (!to_do_.empty())
    text << "; the others take about " << durationText(left_.about_s) << ", at most "
         << durationText(left_.at_most_s);
  if (!experiment_.left_out_threads.empty()) {
    text << "; left out, since there are not as many cores: threads";
    for (const unsigned threads : experiment_.left_out_threads) text << ' ' << threads;
  }
  return text.str();
}

bool BenchmarkRunner::anyFailedVerification() const {
  return std::any_of(records().begin(), records().end(),
                     [](const RunRecord& r) { return r.solved && !r.verified(); });
}

bool BenchmarkRunner::anyCrashed() const {
  return std::any_of(records().begin(), records().end(), [](const RunRecord& r) { return r.crashed; });
}

bool BenchmarkRunner::anySolved() const {
  return std::any_of(records().begin(), records().end(), [](const RunRecord& r) { return r.solved; });
}

std::string BenchmarkRunner::report() const { return summaryTables(recorded_contenders_, records()); }

void BenchmarkRunner::writeSummary() const {
  std::map<std::string, int> builds;
  for (const RunRecord& record : records()) ++builds[record.build.at("commit")];
  std::ostringstream text;
  text << "# " << experiment_.name << "\n\n"
       << outlook()
       << ".\n\nTimes run from the start of planning (drawing of start states included) to the path, for "
          "runs whose path was verified; all other runs count as longer than the limit.\n\n"
       << report() << "```\n"
       << header();
  for (const auto& [commit, runs] : builds) text << "runs made by commit " << commit << ": " << runs << "\n";
  text << "```\n";
  writeFile((fs::path(folder_) / "summary.md").string(), text.str());
}

}  // namespace b4p
