// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/runner/run_record.h"

#include <sstream>

#include "experiments/json_value.h"
#include "experiments/runner/experiment.h"

namespace b4p {
namespace {

constexpr int kSchema = 1;
constexpr const char* kEither = "either";
constexpr const char* kBoth = "both";

Json toJson(const OmplRun& ompl) {
  Json rows = Json::array();
  for (const auto& sample : ompl.progress) {
    Json row = Json::array();
    for (const std::string& name : ompl.progress_names) {
      const auto value = sample.find(name);
      row.push_back(value == sample.end() ? Json(nullptr) : Json(value->second));
    }
    rows.push_back(row);
  }
  return {{"common", Json(ompl.common)},
          {"columns", Json(ompl.columns)},
          {"progress_names", ompl.progress_names},
          {"progress", rows}};
}

OmplRun readOmpl(const JsonValue& element) {
  element.requireKeys({"common", "columns", "progress_names", "progress"});
  OmplRun ompl;
  ompl.common = element["common"].texts();
  ompl.columns = element["columns"].texts();
  for (const JsonValue& name : element["progress_names"].items()) ompl.progress_names.push_back(name.text());
  for (const JsonValue& row : element["progress"].items()) {
    const auto values = row.items(ompl.progress_names.size());
    auto& sample = ompl.progress.emplace_back();
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!values[i].isNull()) sample[ompl.progress_names[i]] = values[i].text();
  }
  return ompl;
}

Json toJson(const PlacementSeries& series) {
  Json improvements = Json::array();
  for (const PlacementSeries::Improvement& i : series.improvements)
    improvements.push_back({{"time_s", i.time_s},
                            {"cpu_s", i.cpu_s},
                            {"objective_m", i.objective_m},
                            {"recomputed_m", i.recomputed_m},
                            {"arm", i.arm},
                            {"verified", i.verified}});
  return {{"objective", series.objective}, {"object", series.object}, {"improvements", improvements}};
}

PlacementSeries readPlacement(const JsonValue& element) {
  element.requireKeys({"objective", "object", "improvements"});
  PlacementSeries series;
  series.objective = element["objective"].text();
  series.object = element["object"].text();
  for (const JsonValue& item : element["improvements"].items()) {
    item.requireKeys({"time_s", "cpu_s", "objective_m", "recomputed_m", "arm", "verified"});
    series.improvements.push_back({item["time_s"].number(), item["cpu_s"].number(),
                                   item["objective_m"].number(), item["recomputed_m"].number(),
                                   item["arm"].text(), item["verified"].boolean()});
  }
  return series;
}

StopRule readStop(const JsonValue& element) {
  const std::string stop = element.text();
  if (stop != kEither && stop != kBoth) element.failWithValue("is neither both nor either");
  return stop == kBoth ? StopRule::kBoth : StopRule::kEither;
}

RunLimits readLimits(const JsonValue& root) {
  RunLimits limits;
  limits.time_s = root["time_limit_s"].number();
  if (!root["check_limit"].isNull()) limits.checks = root["check_limit"].integer<std::uint64_t>();
  limits.stop = readStop(root["stop"]);
  if (root.has("clock")) limits.clock = runClock(root["clock"].text(), root.file(), "clock");
  return limits;
}

}  // namespace

std::string recordLine(const RunRecord& record) {
  const RunLimits& limits = record.limits;
  Json document = {{"schema", kSchema},
                   {"scene", record.scene},
                   {"label", record.label},
                   {"run", record.run},
                   {"planner", record.planner},
                   {"checker", record.checker},
                   {"seed", record.seed},
                   {"threads", record.threads},
                   {"time_limit_s", limits.time_s},
                   {"check_limit", limits.checks ? Json(*limits.checks) : Json(nullptr)},
                   {"stop", limits.stop == StopRule::kBoth ? kBoth : kEither},
                   {"status", record.status},
                   {"solved", record.solved},
                   {"verified", record.verification_passed},
                   {"verification_failure", record.verification_failure},
                   {"crashed", record.crashed},
                   {"crash", record.crash},
                   {"grasp_id", record.grasp_id},
                   {"time_s", record.time_s},
                   {"cpu_s", record.cpu_s},
                   {"wall_s", record.wall_s},
                   {"checks", record.checks},
                   {"edge_checks", record.edge_checks},
                   {"build", Json(record.build)},
                   {"ompl", toJson(record.ompl)}};
  if (limits.clock != RunClock::kElapsed) document["clock"] = nameOf(limits.clock);
  if (record.placement) document["placement"] = toJson(*record.placement);
  return document.dump(-1, ' ', false, Json::error_handler_t::replace);
}

RunRecord recordFrom(const std::string& line, const std::string& where) {
  std::istringstream stream(line);
  const Json document = parseJson(stream, where);
  const JsonValue root(where, "", document);
  root.requireSchema(kSchema);
  root.requireKeys(
      {"schema",       "scene",       "label",    "run",    "planner", "seed",     "threads",
       "time_limit_s", "check_limit", "stop",     "status", "solved",  "verified", "verification_failure",
       "crashed",      "crash",       "grasp_id", "time_s", "cpu_s",   "wall_s",   "checks",
       "edge_checks",  "build",       "ompl"},
      {"checker", "clock", "placement"});
  RunRecord record;
  record.scene = root["scene"].text();
  record.label = root["label"].text();
  record.run = root["run"].integer<int>();
  record.planner = root["planner"].text();
  if (root.has("checker")) record.checker = root["checker"].text();
  record.seed = root["seed"].integer<std::uint64_t>();
  record.threads = root["threads"].integer<unsigned>();
  record.limits = readLimits(root);
  record.status = root["status"].text();
  record.solved = root["solved"].boolean();
  record.verification_passed = root["verified"].boolean();
  record.verification_failure = root["verification_failure"].text();
  record.crashed = root["crashed"].boolean();
  record.crash = root["crash"].text();
  record.grasp_id = root["grasp_id"].integer<int>();
  record.time_s = root["time_s"].number();
  record.cpu_s = root["cpu_s"].number();
  record.wall_s = root["wall_s"].number();
  record.checks = root["checks"].integer<std::uint64_t>();
  record.edge_checks = root["edge_checks"].integer<std::uint64_t>();
  record.build = root["build"].texts();
  record.ompl = readOmpl(root["ompl"]);
  if (root.has("placement")) record.placement = readPlacement(root["placement"]);
  return record;
}

}  // namespace b4p
