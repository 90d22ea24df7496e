// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/runner/settings_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "experiments/json_value.h"
#include "experiments/output_file.h"
#include "robots/input_error.h"

namespace b4p {
namespace {

constexpr int kSchema = 1;
constexpr int kIndent = 1;
constexpr const char* kRuns = "runs";
constexpr const char* kChecker = "checker";
constexpr const char* kClock = "clock";

template <class Value>
Json orNull(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

std::string contentOf(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// All that is read for a scene but its robot, that of single arms included.
std::string sceneContent(const Scene& scene) {
  std::string content = contentOf(scene.file);
  if (const auto* reach = std::get_if<ReachTask>(&scene.task); reach && !reach->grasp_file.empty())
    content += contentOf(reach->grasp_file);
  if (const auto* task = std::get_if<PickPlaceTask>(&scene.task); task && !task->grasps.grasp_file.empty())
    content += contentOf(task->grasps.grasp_file);
  if (const auto* placing = std::get_if<PlacementTask>(&scene.task))
    for (const PlacementArm& arm : placing->arms)
      if (arm.robot_file != scene.robot.file) content += contentOf(arm.robot_file) + contentOf(arm.urdf_file);
  return content;
}

Json toJson(const Experiment& experiment, const ListedScene& listed) {
  const auto checks = experiment.check_limits.find(listed.given);
  const RobotFile& robot = listed.scene.robot;
  return {{"time_limit_s", experiment.time_limit_s.value_or(listed.scene.budget_s)},
          {"check_limit", checks == experiment.check_limits.end() ? Json(nullptr) : Json(checks->second)},
          {"scene_file", sceneContent(listed.scene)},
          {"robot_file", contentOf(robot.file)},
          {"urdf_file", contentOf(robot.urdf_file)}};
}

Json toJson(const Experiment& experiment, const Contender& contender) {
  return {{"planner", contender.planner},
          {kChecker, checkerName(contender.checker)},
          {"threads", contender.threads},
          {"parameters", Json(contender.parameters)},
          {"scene_parameters", Json(contender.scene_parameters)},
          {kRuns, experiment.runsOf(contender)}};
}

Json toJson(const Experiment& experiment, const std::vector<ListedScene>& scenes) {
  Json by_scene = Json::object(), by_label = Json::object();
  for (const ListedScene& listed : scenes) by_scene[listed.scene.name] = toJson(experiment, listed);
  for (const Contender& contender : experiment.contenders)
    by_label[contender.label] = toJson(experiment, contender);
  return {{"schema", kSchema},
          {"name", experiment.name},
          {"seed", experiment.seed},
          {"check_cost_us", orNull(experiment.check_cost_us)},
          {"stop", experiment.stop == StopRule::kBoth ? "both" : "either"},
          {kClock, nameOf(experiment.clock)},
          {"scenes", by_scene},
          {"planners", by_label}};
}

/// Looks for the first value that differs, and names it.
void requireSame(const std::string& file, const std::string& element, const Json& there, const Json& here) {
  constexpr std::size_t kLongest = 40;
  if (there == here) return;
  if (there.is_object() && here.is_object())
    for (const auto& item : there.items())
      if (here.contains(item.key()))
        requireSame(file, element + "." + item.key(), item.value(), here[item.key()]);
  const std::string was = there.dump(), is = here.dump();
  throw InputError(file, element,
                   was.size() > kLongest || is.size() > kLongest
                       ? "has changed since the runs in this folder; take another folder"
                       : "is " + was + " in this folder, " + is + " in the experiment; take another folder");
}

/// Adds what is new in `here` to `there`; what is in both has to agree, but for the number of runs.
void merge(const std::string& file, const std::string& group, Json& there, const Json& here) {
  for (const auto& item : here.items()) {
    if (!there.contains(item.key())) {
      there[item.key()] = item.value();
      continue;
    }
    Json& old = there[item.key()];
    Json adapted = item.value();
    if (adapted.contains(kRuns)) {
      const int runs = std::max(adapted[kRuns].get<int>(), old[kRuns].get<int>());
      adapted[kRuns] = old[kRuns] = runs;
      if (!old.contains(kChecker)) old[kChecker] = checkerName(CheckerKind::kFcl);
    }
    requireSame(file, group + "." + item.key(), old, adapted);
  }
}

/// Finds every fault that the file may have by itself.
std::vector<Contender> readContenders(const JsonValue& root) {
  root.requireSchema(kSchema);
  root.requireKeys({"schema", "name", "seed", "check_cost_us", "stop", "scenes", "planners"}, {kClock});
  for (const auto& [name, scene] : root["scenes"].entries())
    scene.requireKeys({"time_limit_s", "check_limit", "scene_file", "robot_file", "urdf_file"});
  std::vector<Contender> contenders;
  for (const auto& [label, planner] : root["planners"].entries()) {
    planner.requireKeys({"planner", "threads", "parameters", "scene_parameters", kRuns}, {kChecker});
    Contender& contender = contenders.emplace_back();
    contender.label = label;
    contender.planner = planner["planner"].text();
    // Folders that do not say are older than the choice.
    contender.checker = planner.has(kChecker) ? checkerNamed(planner[kChecker].text(), root.file(), kChecker)
                                              : CheckerKind::kFcl;
    contender.threads = planner["threads"].integer<unsigned>();
    contender.parameters = planner["parameters"].texts();
    for (const auto& [scene, parameters] : planner["scene_parameters"].entries())
      contender.scene_parameters[scene] = parameters.texts();
    contender.runs = planner[kRuns].integer<int>();
  }
  return contenders;
}

}  // namespace

std::vector<Contender> reconcileSettings(const std::string& file, const Experiment& experiment,
                                         const std::vector<ListedScene>& scenes) {
  const Json here = toJson(experiment, scenes);
  Json merged = here;
  if (std::filesystem::exists(file)) {
    merged = readJson(file);
    readContenders(JsonValue(file, "", merged));
    if (!merged.contains(kClock)) merged[kClock] = nameOf(RunClock::kElapsed);
    for (const char* key : {"name", "seed", "check_cost_us", "stop", kClock})
      requireSame(file, key, merged[key], here[key]);
    merge(file, "scenes", merged["scenes"], here["scenes"]);
    merge(file, "planners", merged["planners"], here["planners"]);
  }
  writeFile(file, merged.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n");
  return readContenders(JsonValue(file, "", merged));
}

}  // namespace b4p
