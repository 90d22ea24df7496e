// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/runner/placement_run.h"

#include <limits>

#include "experiments/placement/placement_check.h"
#include "experiments/runner/column_number.h"
#include "robots/input_error.h"

namespace b4p {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

PlacementQuerySettings placementSettings(const QuerySettings& settings) {
  PlacementQuerySettings placing;
  placing.parameters = settings.parameters;
  placing.threads = settings.threads;
  placing.seed = settings.seed;
  placing.time_limit_s = settings.time_limit_s;
  placing.clock = settings.clock;
  return placing;
}

}  // namespace

PlacementRun::PlacementRun(const ListedScene& listed, const PlannerCatalogue& catalogue,
                           const QuerySettings& settings, const std::string& where)
    : settings_((check(listed, catalogue, settings, where), settings)),
      query_(listed.scene, listed.given, placementSettings(settings), where) {}

void PlacementRun::check(const ListedScene& listed, const PlannerCatalogue& catalogue,
                         const QuerySettings& settings, const std::string& where) {
  findFitting(catalogue, settings.planner, listed.scene, where);
  if (settings.check_limit)
    throw InputError(where, "",
                     "a limit of checks is not for a task of placement such as '" + listed.scene.name + "'");
  PlacementQuery::check(placementSettings(settings), where);
}

void PlacementRun::conclude(const ompl::base::PlannerStatus& status) {
  result_ = query_.result(status);
  verifyImprovements(query_.problem().scene, result_);
  failure_ = firstFailure(result_);
}

bool PlacementRun::finished() const { return planner()->elapsed_s() >= settings_.time_limit_s; }

double PlacementRun::firstTime_s() const {
  return result_.solved() ? result_.improvements.front().time_s : kNone;
}

void PlacementRun::fill(RunRecord& record) const {
  record.planner = settings_.planner;
  record.checker = checkerName(CheckerKind::kFcl);
  record.seed = result_.seed;
  record.threads = settings_.threads;
  record.status = result_.status;
  record.solved = result_.solved();
  record.verification_passed = verified();
  record.verification_failure = failure_;
  record.crashed = !planner()->crash().empty();
  record.crash = planner()->crash();
  record.time_s = result_.solved() ? firstTime_s() : result_.planning_time_s;
  record.cpu_s = planner()->cpu_s();
  record.checks = query_.problem().counts->states;
  record.edge_checks = query_.problem().counts->edges;
  PlacementSeries& series = record.placement.emplace();
  series.objective = result_.objective;
  series.object = query_.problem().scene.placing().object_name;
  for (const PlacementImprovement& improvement : result_.improvements)
    series.improvements.push_back(
        {improvement.time_s, improvement.cpu_s, improvement.objective_m, improvement.verification.objective_m,
         result_.arms[static_cast<std::size_t>(improvement.arm)], improvement.verification.passed});
  if (result_.solved()) record.grasp_id = result_.improvements.back().arm;
}

std::map<std::string, std::string> PlacementRun::columns() const {
  std::map<std::string, std::string> columns;
  columns["arm INTEGER"] = std::to_string(result_.solved() ? result_.improvements.back().arm : -1);
  columns["improvements INTEGER"] = std::to_string(result_.improvements.size());
  columns["placements drawn INTEGER"] = std::to_string(result_.draws.draws);
  columns["valid placements INTEGER"] = std::to_string(result_.draws.valid);
  columns["best objective REAL"] =
      columnNumber(result_.solved() ? result_.improvements.back().objective_m : kNone);
  columns["edge checks INTEGER"] = std::to_string(query_.problem().counts->edges);
  columns["cpu time REAL"] = columnNumber(planner()->cpu_s());
  columns["verified BOOLEAN"] = verified() ? "1" : "0";
  columns["seed INTEGER"] = std::to_string(result_.seed);
  columns["threads INTEGER"] = std::to_string(settings_.threads);
  columns["time to verified path REAL"] = columnNumber(verified() ? firstTime_s() : kNone);
  return columns;
}

}  // namespace b4p
