// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/virtual_time_b4p.h"

#include <utility>

namespace b4p {

VirtualTimeB4P::VirtualTimeB4P(const ompl::base::SpaceInformationPtr& si, double limit_s, CostClock cost)
    : B4P(si), limit_s_(limit_s), cost_(std::move(cost)) {}

ompl::base::PlannerStatus VirtualTimeB4P::solve(const ompl::base::PlannerTerminationCondition& ptc) {
  report_ = {};
  const ompl::base::PlannerStatus status = B4P::solve(ptc);
  report_.finished = status == ompl::base::PlannerStatus::EXACT_SOLUTION;
  return status;
}

void VirtualTimeB4P::work(const std::function<void(std::size_t)>& step, const std::function<bool()>& over,
                          const ompl::base::PlannerTerminationCondition& ptc) {
  VirtualTime time(parameters().threads, log_, cost_);
  const VirtualTime::Report part = time.run(step, over, ptc, limit_s_ - report_.time_s);
  report_.time_s += part.time_s;
  report_.work_s += part.work_s;
  report_.steps += part.steps;
}

}  // namespace b4p
