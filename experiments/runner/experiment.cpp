// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/runner/experiment.h"

#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <thread>

#include "experiments/named_values.h"
#include "experiments/placement/placement_query.h"
#include "experiments/scene_files/data_files.h"
#include "experiments/scene_files/yaml_value.h"

namespace b4p {
namespace {

constexpr int kSchema = 1;
constexpr int kMostRuns = 100000;
constexpr int kMostThreads = 64;
constexpr double kMostChecks = 1e15;
constexpr double kLargestCheckCost_us = 1e6;
constexpr double kMicrosecond_s = 1e-6;

constexpr std::array<Named<RunClock>, 2> kClocks{
    {{RunClock::kElapsed, "elapsed"}, {RunClock::kProcessor, "processor"}}};

std::string sceneFor(const YamlValue& place, const std::string& scene) {
  if (!isPath(scene)) return scene;
  return std::filesystem::absolute(relativeTo(place.file(), scene)).lexically_normal().string();
}

/// Thread counts of a planner, or of all that state none.
struct ThreadCounts {
  std::vector<unsigned> counts;
  bool several = false;  ///< a list: labels say which count is theirs
};

/// One number or a list of them. Of a list, those beyond the cores of this machine are left out where the
/// experiment says so.
ThreadCounts readThreads(const YamlValue& value, bool skip_beyond_cores, std::vector<unsigned>& left_out) {
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  ThreadCounts threads;
  threads.several = value.isList();
  if (!threads.several) return {{static_cast<unsigned>(value.integer(1, kMostThreads))}, false};
  for (const YamlValue& item : value.items()) {
    const auto count = static_cast<unsigned>(item.integer(1, kMostThreads));
    if (std::count(threads.counts.begin(), threads.counts.end(), count) > 0)
      item.failWithValue("is listed twice");
    if (!skip_beyond_cores || count <= cores)
      threads.counts.push_back(count);
    else if (std::count(left_out.begin(), left_out.end(), count) == 0)
      left_out.push_back(count);
  }
  if (threads.counts.empty()) value.failWithValue("leaves no thread count for this machine");
  return threads;
}

PlannerParameters readParameters(const YamlValue& mapping) {
  PlannerParameters parameters;
  for (const auto& [name, value] : mapping.entries())
    if (!parameters.emplace(name, value.text()).second) value.fail("duplicate key");
  return parameters;
}

/// What the key `checker` says, where it is there.
CheckerKind readChecker(const YamlValue& mapping, CheckerKind otherwise) {
  const auto checker = mapping.find("checker");
  if (!checker) return otherwise;
  for (const CheckerKind kind : {CheckerKind::kFast, CheckerKind::kFcl})
    if (checker->isWord(checkerName(kind).c_str())) return kind;
  checker->failWithValue("is neither fast nor fcl");
}

/// The scene that a key names: one of those that the file lists.
std::string listedScene(const std::string& key, const YamlValue& value,
                        const std::vector<std::string>& listed) {
  const std::string scene = sceneFor(value, key);
  if (std::count(listed.begin(), listed.end(), scene) == 0) value.fail("is none of the scenes listed");
  return scene;
}

/// Reads the experiment's planners, one contender per thread count.
class ContenderReader {
 public:
  ContenderReader(Experiment& experiment, ThreadCounts threads, bool skip_beyond_cores, CheckerKind checker)
      : experiment_(experiment),
        threads_(std::move(threads)),
        skip_beyond_cores_(skip_beyond_cores),
        checker_(checker) {}

  void read(const YamlValue& item) {
    item.allowKeys({"label", "planner", "threads", "runs", "checker", "parameters", "scene_parameters"});
    Contender contender;
    contender.planner = item["planner"].text();
    contender.checker = readChecker(item, checker_);
    if (const auto runs = item.find("runs")) contender.runs = runs->integer(1, kMostRuns);
    if (const auto parameters = item.find("parameters")) contender.parameters = readParameters(*parameters);
    if (const auto scenes = item.find("scene_parameters"))
      for (const auto& [key, parameters] : scenes->entries())
        contender.scene_parameters[listedScene(key, parameters, experiment_.scenes)] =
            readParameters(parameters);
    ThreadCounts threads = threads_;
    if (const auto own = item.find("threads"))
      threads = readThreads(*own, skip_beyond_cores_, experiment_.left_out_threads);
    const std::string label = item["label"].word();
    for (const unsigned count : threads.counts) {
      contender.label = threads.several ? label + "_" + std::to_string(count) : label;
      contender.threads = count;
      add(item, contender);
    }
  }

 private:
  void add(const YamlValue& item, const Contender& contender) {
    for (const Contender& other : experiment_.contenders)
      if (other.label == contender.label) item["label"].failWithValue("is the label of an earlier planner");
    experiment_.contenders.push_back(contender);
  }

  Experiment& experiment_;
  ThreadCounts threads_;
  bool skip_beyond_cores_;
  CheckerKind checker_;
};

bool matches(const std::string& scene, const std::string& pattern) {
  return fnmatch(pattern.c_str(), scene.c_str(), FNM_PATHNAME) == 0;
}

bool isPattern(const std::string& name_or_path) {
  return !isPath(name_or_path) && name_or_path.find_first_of("*?[") != std::string::npos;
}

/// The scene that an item of the list means, or all shipped ones that its pattern does.
std::vector<std::string> scenesOf(const YamlValue& item) {
  const std::string text = item.text();
  if (!isPattern(text)) return {sceneFor(item, text)};
  std::vector<std::string> scenes;
  for (const std::string& name : sceneNames())
    if (matches(name, text)) scenes.push_back(name);
  if (scenes.empty()) item.failWithValue("fits no scene that ships with b4p");
  return scenes;
}

void readScenes(const YamlValue& document, Experiment& experiment) {
  for (const YamlValue& item : document["scenes"].items())
    for (const std::string& scene : scenesOf(item)) {
      if (std::count(experiment.scenes.begin(), experiment.scenes.end(), scene) > 0)
        item.failWithValue("lists a scene twice");
      experiment.scenes.push_back(scene);
    }
  if (experiment.scenes.empty()) document["scenes"].fail("is empty");
}

void readObjectives(const YamlValue& document, Experiment& experiment) {
  const auto list = document.find("objectives");
  if (!list) return;
  auto& objectives = experiment.objectives;
  for (const YamlValue& item : list->items()) {
    const auto known = {ClearanceGoal::kLargest, ClearanceGoal::kSmallest};
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&](ClearanceGoal goal) { return item.isWord(nameOf(goal).c_str()); });
    if (found == known.end()) item.failWithValue("is neither max_clearance nor min_clearance");
    if (std::count(objectives.begin(), objectives.end(), *found) > 0) item.failWithValue("is listed twice");
    objectives.push_back(*found);
  }
  if (objectives.empty()) list->fail("is empty");
}

std::uint64_t checksFrom(const YamlValue& value) {
  return static_cast<std::uint64_t>(std::llround(value.number(1.0, kMostChecks)));
}

void readLimits(const YamlValue& document, Experiment& experiment) {
  const YamlValue time = document["time_limit_s"];
  if (!time.isWord("scene")) experiment.time_limit_s = time.positive();
  const auto checks = document.find("check_limit");
  const auto cost = document.find("check_cost_us");
  const auto stop = document.find("stop");
  if (checks && cost) cost->fail("there is a check_limit already; state one of them");
  if (cost) experiment.check_cost_us = cost->positive(kLargestCheckCost_us);
  if (checks && checks->isMapping()) {
    for (const auto& [key, value] : checks->entries())
      experiment.check_limits[listedScene(key, value, experiment.scenes)] = checksFrom(value);
    for (const std::string& scene : experiment.scenes)
      if (experiment.check_limits.count(scene) == 0) checks->fail("says nothing about scene '" + scene + "'");
  } else if (checks) {
    for (const std::string& scene : experiment.scenes) experiment.check_limits[scene] = checksFrom(*checks);
  }
  if (const auto clock = document.find("clock"))
    experiment.clock = runClock(clock->text(), document.file(), "clock");
  if (!stop) return;
  if (!checks && !cost) stop->fail("needs a check_limit or check_cost_us beside the time limit");
  if (stop->isWord("both"))
    experiment.stop = StopRule::kBoth;
  else if (!stop->isWord("either"))
    stop->failWithValue("is neither both nor either");
}

/// Whether a name or pattern means a scene.
bool means(const std::string& name, const std::string& scene) {
  return name == scene || (isPattern(name) && matches(scene, name));
}

void keepScenes(const std::vector<std::string>& wanted, const YamlValue& document, Experiment& experiment) {
  if (wanted.empty()) return;
  auto& scenes = experiment.scenes;
  for (const std::string& name : wanted)
    if (std::none_of(scenes.begin(), scenes.end(), [&](const auto& scene) { return means(name, scene); }))
      document["scenes"].fail("does not list '" + name + "', which was asked for");
  scenes.erase(std::remove_if(scenes.begin(), scenes.end(),
                              [&wanted](const std::string& scene) {
                                return std::none_of(wanted.begin(), wanted.end(),
                                                    [&](const auto& name) { return means(name, scene); });
                              }),
               scenes.end());
}

}  // namespace

PlannerParameters Contender::parametersFor(const std::string& scene) const {
  PlannerParameters merged = parameters;
  if (const auto own = scene_parameters.find(scene); own != scene_parameters.end())
    for (const auto& [name, value] : own->second) merged[name] = value;
  return merged;
}

RunLimits Experiment::limitsFor(const Contender& contender, const std::string& given,
                                const Scene& scene) const {
  RunLimits limits;
  limits.time_s = time_limit_s.value_or(scene.budget_s);
  limits.stop = stop;
  limits.clock = clock;
  if (const auto own = check_limits.find(given); own != check_limits.end()) limits.checks = own->second;
  if (check_cost_us) {
    const double checks = limits.time_s * contender.threads / (kMicrosecond_s * *check_cost_us);
    limits.checks = static_cast<std::uint64_t>(std::clamp(checks, 1.0, kMostChecks));
  }
  return limits;
}

RunClock runClock(const std::string& name, const std::string& where, const std::string& element) {
  return valueOf(kClocks, name, where, element);
}

std::string nameOf(RunClock clock) { return nameIn(kClocks, clock); }

Experiment loadExperiment(const std::string& file, const ExperimentOverrides& overrides) {
  const YamlValue document = YamlValue::load(file);
  document.requireSchema(kSchema);
  document.allowKeys({"schema", "name", "runs", "time_limit_s", "clock", "check_limit", "check_cost_us",
                      "stop", "threads", "skip_threads_beyond_cores", "seed", "checker", "scenes",
                      "objectives", "planners"});
  Experiment experiment;
  experiment.file = file;
  experiment.name = document["name"].word();
  experiment.runs = document["runs"].integer(1, kMostRuns);
  experiment.seed = static_cast<std::uint64_t>(document["seed"].integer(0, std::numeric_limits<int>::max()));
  readScenes(document, experiment);
  readObjectives(document, experiment);
  readLimits(document, experiment);

  const auto skip = document.find("skip_threads_beyond_cores");
  const bool skip_beyond_cores = skip && skip->boolean();
  ThreadCounts threads = readThreads(document["threads"], skip_beyond_cores, experiment.left_out_threads);
  if (!overrides.threads.empty()) {
    threads = {overrides.threads, threads.several || overrides.threads.size() > 1};
    experiment.left_out_threads.clear();
  }
  ContenderReader contenders(experiment, threads, skip_beyond_cores,
                             readChecker(document, CheckerKind::kFast));
  for (const YamlValue& item : document["planners"].items()) contenders.read(item);
  if (experiment.contenders.empty()) document["planners"].fail("is empty");

  experiment.seed = overrides.seed.value_or(experiment.seed);
  if (overrides.time_limit_s) experiment.time_limit_s = overrides.time_limit_s;
  experiment.clock = overrides.clock.value_or(experiment.clock);
  if (overrides.runs) {
    experiment.runs = *overrides.runs;
    for (Contender& contender : experiment.contenders) contender.runs = 0;
  }
  if (overrides.checker)
    for (Contender& contender : experiment.contenders) contender.checker = *overrides.checker;
  keepScenes(overrides.scenes, document, experiment);
  return experiment;
}

}  // namespace b4p
