// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planners/b4p/b4p_planner.h"
#include "planners/b4p/publication_log.h"
#include "planners/b4p/virtual_time.h"

namespace b4p {

/// B4P whose `threads` workers run in logical time (VirtualTime), on the calling thread alone: how long that
/// many cores would take if they shared nothing but the forests. Memory bandwidth, caches and locks are not
/// in it. With one worker it makes the path that B4P makes.
class VirtualTimeB4P : public B4P {
 public:
  /// @param limit_s  logical time after which no step of a solve() begins any more (s, > 0)
  VirtualTimeB4P(const ompl::base::SpaceInformationPtr& si, double limit_s, CostClock cost = threadCost);

  using Planner::solve;
  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& ptc) override;

  /// Of the last solve(), restarts included. Each begins at 0.
  const VirtualTime::Report& report() const { return report_; }

 protected:
  PublicationLog* publicationLog() override { return &log_; }
  void work(const std::function<void(std::size_t)>& step, const std::function<bool()>& over,
            const ompl::base::PlannerTerminationCondition& ptc) override;

 private:
  double limit_s_;
  CostClock cost_;
  PublicationLog log_;
  VirtualTime::Report report_;
};

}  // namespace b4p
