// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/placement_result.h"

#include <algorithm>

#include "experiments/output_file.h"
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
          {"objective_m", improvement.objective_m},
          {"arm", result.arms[arm]},
          {"joint_names", result.joint_names[arm]},
          {"X_WO_place", poseJson(improvement.X_WO, "X_WO_place")},
          {"path", improvement.path},
          {"verification", verificationJson(improvement.verification)}};
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

}  // namespace

bool PlacementResult::verified() const {
  return std::all_of(improvements.begin(), improvements.end(),
                     [](const PlacementImprovement& improvement) { return improvement.verification.passed; });
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
                {"improvements", Json::array()}};
  for (const PlacementImprovement& improvement : result.improvements)
    document["improvements"].push_back(improvementJson(result, improvement));
  document["best"] = result.solved() ? document["improvements"].back() : Json();
  writeFile(file, document.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace b4p
