// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/runner/experiment.h"

#include <algorithm>
#include <filesystem>
#include <limits>

#include "experiments/scene_files/data_files.h"
#include "experiments/scene_files/yaml_value.h"

namespace b4p {
namespace {

constexpr int kSchema = 1;
constexpr int kMostRuns = 100000;
constexpr int kMostThreads = 64;

Contender readContender(const YamlValue& item, unsigned threads) {
  item.allowKeys({"label", "planner", "threads", "parameters"});
  Contender contender;
  contender.label = item["label"].word();
  contender.planner = item["planner"].text();
  contender.threads = threads;
  if (const auto own = item.find("threads"))
    contender.threads = static_cast<unsigned>(own->integer(1, kMostThreads));
  if (const auto parameters = item.find("parameters"))
    for (const auto& [name, value] : parameters->entries()) contender.parameters[name] = value.text();
  return contender;
}

std::string sceneFor(const YamlValue& item) {
  const std::string scene = item.text();
  if (!isPath(scene)) return scene;
  return std::filesystem::absolute(relativeTo(item.file(), scene)).lexically_normal().string();
}

}  // namespace

Experiment loadExperiment(const std::string& file, const ExperimentOverrides& overrides) {
  const YamlValue document = YamlValue::load(file);
  document.requireSchema(kSchema);
  document.allowKeys({"schema", "name", "runs", "time_limit_s", "threads", "seed", "scenes", "planners"});
  Experiment experiment;
  experiment.file = file;
  experiment.name = document["name"].word();
  experiment.runs = document["runs"].integer(1, kMostRuns);
  experiment.time_limit_s = document["time_limit_s"].positive();
  experiment.seed = static_cast<std::uint64_t>(document["seed"].integer(0, std::numeric_limits<int>::max()));
  const auto stated_threads = static_cast<unsigned>(document["threads"].integer(1, kMostThreads));
  const unsigned threads = overrides.threads.value_or(stated_threads);
  experiment.runs = overrides.runs.value_or(experiment.runs);
  experiment.seed = overrides.seed.value_or(experiment.seed);
  experiment.time_limit_s = overrides.time_limit_s.value_or(experiment.time_limit_s);
  for (const YamlValue& item : document["scenes"].items()) {
    experiment.scenes.push_back(sceneFor(item));
    if (std::count(experiment.scenes.begin(), experiment.scenes.end(), experiment.scenes.back()) > 1)
      item.failWithValue("is listed twice");
  }
  if (experiment.scenes.empty()) document["scenes"].fail("is empty");
  for (const YamlValue& item : document["planners"].items()) {
    Contender contender = readContender(item, threads);
    for (const Contender& other : experiment.contenders)
      if (other.label == contender.label) item["label"].failWithValue("is the label of an earlier planner");
    experiment.contenders.push_back(std::move(contender));
  }
  if (experiment.contenders.empty()) document["planners"].fail("is empty");
  return experiment;
}

}  // namespace b4p
