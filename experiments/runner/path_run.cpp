// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/runner/path_run.h"

#include <limits>

#include "experiments/runner/column_number.h"
#include "experiments/tcp_path_length.h"
#include "experiments/verification/verifier.h"

namespace b4p {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kTcpPathLength = "tcp path length REAL";  ///< m

/// A planner's progress property by its name, "0" where it has none.
std::string property(const ompl::base::Planner& planner, const std::string& name) {
  const auto& properties = planner.getPlannerProgressProperties();
  const auto found = properties.find(name);
  return found == properties.end() ? "0" : found->second();
}

}  // namespace

PathRun::PathRun(const ListedScene& listed, const PlannerCatalogue& catalogue, const QuerySettings& settings,
                 const std::string& where)
    : query_(listed.scene, listed.given, catalogue, settings, where) {}

void PathRun::conclude(const ompl::base::PlannerStatus& status) {
  result_ = query_.result(status);
  if (result_.solved) result_.verification = verify(query_.problem().scene, result_);
}

void PathRun::fill(RunRecord& record) const {
  record.planner = result_.planner;
  record.checker = result_.checker;
  record.seed = result_.seed;
  record.threads = result_.threads;
  record.status = result_.status;
  record.solved = result_.solved;
  record.verification_passed = result_.solved && result_.verification.passed;
  record.verification_failure = result_.verification.failure;
  record.crashed = crashed(result_);
  if (record.crashed) record.crash = planner()->crash();
  record.grasp_id = result_.grasp_id;
  record.time_s = result_.planning_time_s;
  record.cpu_s = query_.cpu_s();
  record.checks = query_.configurationsChecked();
  record.edge_checks = query_.edgeChecks();
}

std::map<std::string, std::string> PathRun::columns() const {
  const bool verified = result_.solved && result_.verification.passed;
  std::map<std::string, std::string> columns;
  columns["grasp id INTEGER"] = std::to_string(result_.grasp_id);
  for (const char* name : {"repairs tried INTEGER", "repairs succeeded INTEGER"})
    columns[name] = property(*planner(), name);
  columns["validity checks INTEGER"] = std::to_string(query_.configurationsChecked());
  columns["edge checks INTEGER"] = std::to_string(query_.edgeChecks());
  columns["cpu time REAL"] = columnNumber(query_.cpu_s());
  columns["verified BOOLEAN"] = verified ? "1" : "0";
  columns["seed INTEGER"] = std::to_string(result_.seed);
  columns["threads INTEGER"] = std::to_string(result_.threads);
  columns["time to verified path REAL"] = columnNumber(verified ? result_.planning_time_s : kNone);
  columns[kTcpPathLength] =
      columnNumber(result_.solved ? tcpPathLength_m(*query_.problem().robot, result_.path) : kNone);
  return columns;
}

}  // namespace b4p
