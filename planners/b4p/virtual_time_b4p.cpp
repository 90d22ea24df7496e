// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/virtual_time_b4p.h"

#include <utility>

namespace b4p {

VirtualTimeB4P::VirtualTimeB4P(const ompl::base::SpaceInformationPtr& si, double limit_s, CostClock cost)
    : B4P(si), limit_s_(limit_s), cost_(std::move(cost)) {}

void VirtualTimeB4P::work(const std::function<void(std::size_t)>& step, const std::function<bool()>& finished,
                          const ompl::base::PlannerTerminationCondition& ptc) {
  report_ = {};
  VirtualTime time(parameters().threads, log_, cost_);
  report_ = time.run(step, finished, ptc, limit_s_);
}

}  // namespace b4p
