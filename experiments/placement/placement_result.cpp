// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/placement_result.h"

#include <algorithm>

#include "experiments/output_file.h"
#include "experiments/placement/clearance_objective.h"
#include "experiments/placement/placement_result_json.h"
#include "experiments/result_json.h"

namespace b4p {
namespace {

constexpr int kSchema = 1;
constexpr int kIndent = 1;

Json verificationJson(const PlacementVerification& verification) {
  return {{"passed", verification.passed},
          {"failure", verification.failure},
          {"step_m", verification.step_m},
          {"configurations", verification.configurations},
          {"clearance_m", verification.clearance_m},
          {"objective_m", verification.objective_m},
          {"gap_m", verification.gap_m}};
}

Json improvementJson(const PlacementResult& result, const PlacementImprovement& improvement) {
  const auto arm = static_cast<std::size_t>(improvement.arm);
  return {{"time_s", improvement.time_s},
          {"cpu_s", improvement.cpu_s},
          {"objective_m", improvement.objective_m},
          {"arm", result.arms[arm]},
          {"X_WO_place", poseJson(improvement.X_WO, "X_WO_place")},
          {"path", improvement.path},
          {"verification", verificationJson(improvement.verification)}};
}

Json armsJson(const PlacementResult& result) {
  Json arms = Json::array();
  for (std::size_t i = 0; i < result.arms.size(); ++i)
    arms.push_back({{"name", result.arms[i]}, {"joint_names", result.joint_names[i]}});
  return arms;
}

Json drawsJson(const PlacementStatistics& draws) {
  return {{"all", draws.draws},
          {"valid", draws.valid},
          {"unstable", draws.unstable},
          {"object_collides", draws.object_collides},
          {"not_better", draws.not_better},
          {"hand_collides", draws.hand_collides},
          {"unreachable", draws.unreachable},
          {"arm_collides", draws.arm_collides},
          {"exhausted", draws.exhausted}};
}

PlacementVerification verificationFrom(const JsonValue& value) {
  value.requireKeys({"passed", "failure", "step_m", "configurations", "clearance_m", "objective_m", "gap_m"});
  PlacementVerification verification;
  verification.passed = value["passed"].boolean();
  verification.failure = value["failure"].text();
  verification.step_m = value["step_m"].number();
  verification.configurations = value["configurations"].integer<long>();
  verification.clearance_m = value["clearance_m"].number();
  verification.objective_m = value["objective_m"].number();
  verification.gap_m = value["gap_m"].number();
  return verification;
}

PlacementImprovement improvementFrom(const JsonValue& value, const PlacementResult& result) {
  value.requireKeys({"time_s", "objective_m", "arm", "X_WO_place", "path", "verification"}, {"cpu_s"});
  PlacementImprovement improvement;
  improvement.time_s = value["time_s"].number();
  if (value.has("cpu_s")) improvement.cpu_s = value["cpu_s"].number();
  improvement.objective_m = value["objective_m"].number();
  const auto arm = std::find(result.arms.begin(), result.arms.end(), value["arm"].text());
  if (arm == result.arms.end()) value["arm"].failWithValue("is no arm of the list");
  improvement.arm = static_cast<int>(arm - result.arms.begin());
  improvement.X_WO = poseFrom(value["X_WO_place"]);
  const std::size_t joints = result.joint_names[static_cast<std::size_t>(improvement.arm)].size();
  for (const JsonValue& row : value["path"].items()) improvement.path.push_back(row.numbers(joints));
  if (improvement.path.empty()) value["path"].fail("has no way-points");
  improvement.verification = verificationFrom(value["verification"]);
  return improvement;
}

/// Others may read nothing but `best`, so that it has to be what has been verified.
void requireBest(const JsonValue& best, const PlacementResult& result) {
  if (!result.solved()) {
    if (!best.isNull()) best.fail("is there, but there are no improvements");
    return;
  }
  const PlacementImprovement copy = improvementFrom(best, result), &last = result.improvements.back();
  if (copy.arm != last.arm || copy.path != last.path || copy.objective_m != last.objective_m ||
      copy.X_WO.matrix() != last.X_WO.matrix() || copy.time_s != last.time_s)
    best.fail("is not the last of the improvements");
}

}  // namespace

bool PlacementResult::verified() const {
  return std::all_of(improvements.begin(), improvements.end(),
                     [](const PlacementImprovement& improvement) { return improvement.verification.passed; });
}

bool isPlacementResult(const Json& document) {
  return document.is_object() && document.contains("improvements");
}

PlacementResult placementResultFrom(const JsonValue& root) {
  root.requireSchema(kSchema).requireKeys({"schema", "scene", "objective", "sampling", "parameters", "seed",
                                           "time_limit_s", "planning_time_s", "status", "solved", "reason",
                                           "draws", "arms", "improvements", "best"});
  PlacementResult result;
  result.scene = root["scene"].text();
  result.objective = root["objective"].text();
  clearanceGoal(result.objective, root.file(), "objective");
  result.sampling = root["sampling"].text();
  result.parameters = root["parameters"].texts();
  result.seed = root["seed"].integer<std::uint64_t>();
  result.time_limit_s = root["time_limit_s"].number();
  result.planning_time_s = root["planning_time_s"].number();
  result.status = root["status"].text();
  result.reason = root["reason"].text();
  for (const JsonValue& arm : root["arms"].items()) {
    arm.requireKeys({"name", "joint_names"});
    result.arms.push_back(arm["name"].text());
    result.joint_names.emplace_back();
    for (const JsonValue& name : arm["joint_names"].items()) result.joint_names.back().push_back(name.text());
  }
  for (const JsonValue& improvement : root["improvements"].items())
    result.improvements.push_back(improvementFrom(improvement, result));
  if (root["solved"].boolean() != result.solved())
    root["solved"].failWithValue("contradicts the number of improvements");
  requireBest(root["best"], result);
  return result;
}

void writePlacementResult(const std::string& file, const PlacementResult& result) {
  Json document{{"schema", kSchema},
                {"scene", result.scene},
                {"objective", result.objective},
                {"sampling", result.sampling},
                {"parameters", Json(result.parameters)},
                {"seed", result.seed},
                {"time_limit_s", result.time_limit_s},
                {"planning_time_s", result.planning_time_s},
                {"status", result.status},
                {"solved", result.solved()},
                {"reason", result.reason},
                {"draws", drawsJson(result.draws)},
                {"arms", armsJson(result)},
                {"improvements", Json::array()}};
  for (const PlacementImprovement& improvement : result.improvements)
    document["improvements"].push_back(improvementJson(result, improvement));
  document["best"] = result.solved() ? document["improvements"].back() : Json();
  writeFile(file, document.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace b4p
