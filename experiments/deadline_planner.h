// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include <ompl/base/Planner.h>

#include "experiments/run_limits.h"

namespace b4p {

/// Runs another planner with exact limits, where OMPL's Benchmark has a grid of 0.1 s. What has to be
/// done before planning counts against them. An exception out of the planner becomes the status CRASH.
class DeadlinePlanner : public ompl::base::Planner {
 public:
  using Preparation = std::function<void(const ompl::base::PlannerTerminationCondition&)>;

  /// @param prepare  called at the beginning of every solve(), inside the limit; may be empty
  /// @param finish   called at the end of every solve(), outside of its time; may be empty
  /// @param checks   configurations checked since the solve() under way began; may be empty where they are
  ///   not limited
  DeadlinePlanner(const ompl::base::PlannerPtr& planner, const RunLimits& limits, Preparation prepare,
                  std::function<void()> finish, std::function<std::uint64_t()> checks = {});

  using ompl::base::Planner::solve;
  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& ptc) override;
  void setProblemDefinition(const ompl::base::ProblemDefinitionPtr& pdef) override;
  void setup() override;
  void clear() override;
  void getPlannerData(ompl::base::PlannerData& data) const override;

  /// How long the last solve() took (s), by the limits' clock.
  double elapsed_s() const { return elapsed_s_; }
  /// Processor time that the whole process used meanwhile (s): of all threads, and of nobody else.
  double cpu_s() const { return cpu_s_; }
  /// Why the last solve() ended as CRASH: what was thrown, or what a ParallelPlanner says that it caught. ""
  /// otherwise.
  const std::string& crash() const { return crash_; }

 private:
  ompl::base::PlannerPtr planner_;
  RunLimits limits_;
  Preparation prepare_;
  std::function<void()> finish_;
  std::function<std::uint64_t()> checks_;
  double elapsed_s_ = 0.0;
  double cpu_s_ = 0.0;
  std::string crash_;
};

}  // namespace b4p
