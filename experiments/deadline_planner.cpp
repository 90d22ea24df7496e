// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/deadline_planner.h"

#include <exception>
#include <utility>

#include "experiments/interrupt.h"
#include "planners/guarded_planner.h"
#include "planners/processor_time.h"

namespace b4p {

namespace ob = ompl::base;

namespace {

/// Why a planner says that it crashed, having caught the exception by itself.
std::string ownAccount(const ob::Planner& planner) {
  const auto* own = dynamic_cast<const GuardedPlanner*>(&planner);
  return own == nullptr || own->lastError().empty() ? "the planner gives no reason" : own->lastError();
}

}  // namespace

DeadlinePlanner::DeadlinePlanner(const ob::PlannerPtr& planner, const RunLimits& limits, Preparation prepare,
                                 std::function<void()> finish, std::function<std::uint64_t()> checks)
    : ob::Planner(planner->getSpaceInformation(), planner->getName()),
      planner_(planner),
      limits_(limits),
      prepare_(std::move(prepare)),
      finish_(std::move(finish)),
      checks_(std::move(checks)) {
  specs_ = planner->getSpecs();
  params_.include(planner->params());
  plannerProgressProperties_ = planner->getPlannerProgressProperties();
}

ob::PlannerStatus DeadlinePlanner::solve(const ob::PlannerTerminationCondition& ptc) {
  const double cpu_before_s = processTime_s();
  LimitWatch limits(limits_, checks_);
  const ob::PlannerTerminationCondition done(
      [&ptc, &limits] { return limits.reached() || interrupted() || ptc(); });
  ob::PlannerStatus status = ob::PlannerStatus::CRASH;
  crash_.clear();
  try {
    if (prepare_) prepare_(done);
    // Without any start state planners say INVALID_START; here it means that the time ran out.
    status = pdef_->getStartStateCount() == 0 && done() ? ob::PlannerStatus(ob::PlannerStatus::TIMEOUT)
                                                        : planner_->solve(done);
    if (status == ob::PlannerStatus::CRASH) crash_ = ownAccount(*planner_);
  } catch (const std::exception& e) {
    crash_ = e.what();
  } catch (...) {
    crash_ = "unknown exception";
  }
  elapsed_s_ = limits.elapsed_s();
  cpu_s_ = processTime_s() - cpu_before_s;
  if (finish_) finish_();
  return status;
}

void DeadlinePlanner::setProblemDefinition(const ob::ProblemDefinitionPtr& pdef) {
  ob::Planner::setProblemDefinition(pdef);
  planner_->setProblemDefinition(pdef);
}

void DeadlinePlanner::setup() {
  ob::Planner::setup();
  if (!planner_->isSetup()) planner_->setup();
}

void DeadlinePlanner::clear() {
  ob::Planner::clear();
  planner_->clear();
}

void DeadlinePlanner::getPlannerData(ob::PlannerData& data) const { planner_->getPlannerData(data); }

}  // namespace b4p
