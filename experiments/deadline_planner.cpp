// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/deadline_planner.h"

#include <chrono>
#include <exception>
#include <utility>

#include "experiments/interrupt.h"
#include "planners/guarded_planner.h"

namespace b4p {

namespace ob = ompl::base;

namespace {

/// Why a planner says that it crashed, having caught the exception by itself.
std::string ownAccount(const ob::Planner& planner) {
  const auto* own = dynamic_cast<const GuardedPlanner*>(&planner);
  return own == nullptr || own->lastError().empty() ? "the planner gives no reason" : own->lastError();
}

}  // namespace

DeadlinePlanner::DeadlinePlanner(const ob::PlannerPtr& planner, double limit_s, Preparation prepare,
                                 std::function<void()> finish)
    : ob::Planner(planner->getSpaceInformation(), planner->getName()),
      planner_(planner),
      limit_s_(limit_s),
      prepare_(std::move(prepare)),
      finish_(std::move(finish)) {
  specs_ = planner->getSpecs();
  params_.include(planner->params());
  plannerProgressProperties_ = planner->getPlannerProgressProperties();
}

ob::PlannerStatus DeadlinePlanner::solve(const ob::PlannerTerminationCondition& ptc) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const auto end =
      start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limit_s_));
  const ob::PlannerTerminationCondition done(
      [&ptc, end] { return Clock::now() >= end || interrupted() || ptc(); });
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
  elapsed_s_ = std::chrono::duration<double>(Clock::now() - start).count();
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
