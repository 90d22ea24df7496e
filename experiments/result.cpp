// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/result.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "experiments/output_file.h"
#include "experiments/result_json.h"

namespace b4p {
namespace {

constexpr int kSchema = 1;
constexpr int kIndent = 1;
constexpr const char* kReached = "X_WT_reached";

void requireFinite(double number, const char* name) {
  if (!std::isfinite(number)) throw std::invalid_argument(std::string("result: ") + name + " is not finite");
}

Json listOf(const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }

Json toJson(const Verification& verification) {
  requireFinite(verification.step_m, "verification.step_m");
  requireFinite(verification.clearance_m, "verification.clearance_m");
  return {{"passed", verification.passed},
          {"failure", verification.failure},
          {"step_m", verification.step_m},
          {"configurations", verification.configurations},
          {"clearance_m", verification.clearance_m}};
}

Verification readVerification(const JsonValue& element) {
  element.requireKeys({"passed", "failure", "step_m", "configurations", "clearance_m"});
  Verification verification;
  verification.passed = element["passed"].boolean();
  verification.failure = element["failure"].text();
  verification.step_m = element["step_m"].number();
  verification.configurations = element["configurations"].integer<long>();
  verification.clearance_m = element["clearance_m"].number();
  return verification;
}

void readMotion(const JsonValue& root, PlanResult& result) {
  if (root.has(kReached)) {
    result.X_WT_reached = poseFrom(root[kReached]);
  } else {
    result.grasp = graspFrom(root["grasp"]);
    result.X_WO_pick = poseFrom(root["X_WO_pick"]);
    result.X_WO_place = poseFrom(root["X_WO_place"]);
  }
  for (const JsonValue& name : root["joint_names"].items()) result.joint_names.push_back(name.text());
  for (const JsonValue& row : root["path"].items())
    result.path.push_back(row.numbers(result.joint_names.size()));
}

/// What the hand holds, or where it comes to.
Json handJson(const PlanResult& result) {
  if (result.X_WT_reached) return {{kReached, poseJson(*result.X_WT_reached, kReached)}};
  return {{"grasp", graspJson(result.grasp)},
          {"X_WO_pick", poseJson(result.X_WO_pick, "X_WO_pick")},
          {"X_WO_place", poseJson(result.X_WO_place, "X_WO_place")}};
}

}  // namespace

Json poseJson(const Eigen::Isometry3d& X, const char* name) {
  requireFinite(X.matrix().sum(), name);
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i) rows.push_back(listOf(X.linear().row(i)));
  return {{"position_m", listOf(X.translation())}, {"rotation", rows}};
}

Eigen::Isometry3d poseFrom(const JsonValue& pose) {
  pose.requireKeys({"position_m", "rotation"});
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  const std::vector<double> position = pose["position_m"].numbers(3);
  const std::vector<JsonValue> rows = pose["rotation"].items(3);
  for (int i = 0; i < 3; ++i) {
    X.translation()[i] = position[static_cast<std::size_t>(i)];
    const std::vector<double> row = rows[static_cast<std::size_t>(i)].numbers(3);
    for (int j = 0; j < 3; ++j) X.linear()(i, j) = row[static_cast<std::size_t>(j)];
  }
  return X;
}

Json graspJson(const Grasp& grasp) {
  requireFinite(grasp.opening_m, "grasp.opening_m");
  return {{"X_OT", poseJson(grasp.X_OT, "grasp.X_OT")}, {"opening_m", grasp.opening_m}};
}

Grasp graspFrom(const JsonValue& value) {
  value.requireKeys({"X_OT", "opening_m"});
  Grasp grasp;
  grasp.X_OT = poseFrom(value["X_OT"]);
  grasp.opening_m = value["opening_m"].number();
  return grasp;
}

Json resultJson(const PlanResult& result) {
  requireFinite(result.time_limit_s, "time_limit_s");
  requireFinite(result.planning_time_s, "planning_time_s");
  for (const auto& row : result.path)
    for (const double value : row) requireFinite(value, "path");
  Json document{{"schema", kSchema},
                {"scene", result.scene},
                {"planner", result.planner},
                {"checker", result.checker},
                {"parameters", Json(result.parameters)},
                {"seed", result.seed},
                {"threads", result.threads},
                {"time_limit_s", result.time_limit_s},
                {"planning_time_s", result.planning_time_s},
                {"status", result.status},
                {"solved", result.solved},
                {"grasp_id", result.grasp_id}};
  document.update(handJson(result));
  document.update({{"joint_names", result.joint_names},
                   {"path", result.path},
                   {"verification", toJson(result.verification)}});
  return document;
}

void writeResult(const std::string& file, const PlanResult& result) {
  const std::string text = resultJson(result).dump(kIndent, ' ', false, Json::error_handler_t::replace);
  writeFile(file, text + "\n");
}

PlanResult resultFrom(const JsonValue& root) {
  root.requireSchema(kSchema);
  if (root.has(kReached))
    root.requireKeys(
        {"schema", "scene", "planner", "parameters", "seed", "threads", "time_limit_s", "planning_time_s",
         "status", "solved", "grasp_id", kReached, "joint_names", "path", "verification"},
        {"checker"});
  else
    root.requireKeys({"schema", "scene", "planner", "parameters", "seed", "threads", "time_limit_s",
                      "planning_time_s", "status", "solved", "grasp_id", "grasp", "X_WO_pick", "X_WO_place",
                      "joint_names", "path", "verification"},
                     {"checker"});
  PlanResult result;
  result.scene = root["scene"].text();
  result.planner = root["planner"].text();
  if (root.has("checker")) result.checker = root["checker"].text();
  result.parameters = root["parameters"].texts();
  result.seed = root["seed"].integer<std::uint64_t>();
  result.threads = root["threads"].integer<unsigned>();
  result.time_limit_s = root["time_limit_s"].number();
  result.planning_time_s = root["planning_time_s"].number();
  result.status = root["status"].text();
  result.solved = root["solved"].boolean();
  result.grasp_id = root["grasp_id"].integer<int>();
  readMotion(root, result);
  result.verification = readVerification(root["verification"]);
  return result;
}

PlanResult readResult(const std::string& file) {
  const Json document = readJson(file);
  return resultFrom(JsonValue(file, "", document));
}

}  // namespace b4p
