// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include <ompl/base/Planner.h>

namespace b4p {

/// Runs another planner with an exact time limit, where OMPL's Benchmark has a grid of 0.1 s. What has to be
/// done before planning counts against the limit. An exception out of the planner becomes the status CRASH.
class DeadlinePlanner : public ompl::base::Planner {
 public:
  using Preparation = std::function<void(const ompl::base::PlannerTerminationCondition&)>;

  /// @param prepare  called at the beginning of every solve(), inside the limit; may be empty
  /// @param finish   called at the end of every solve(), outside of its time; may be empty
  DeadlinePlanner(const ompl::base::PlannerPtr& planner, double limit_s, Preparation prepare,
                  std::function<void()> finish);

  using ompl::base::Planner::solve;
  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& ptc) override;
  void setProblemDefinition(const ompl::base::ProblemDefinitionPtr& pdef) override;
  void setup() override;
  void clear() override;
  void getPlannerData(ompl::base::PlannerData& data) const override;

  /// How long the last solve() took (s).
  double elapsed_s() const { return elapsed_s_; }
  /// Why the last solve() ended as CRASH: what was thrown, or what a ParallelPlanner says that it caught. ""
  /// otherwise.
  const std::string& crash() const { return crash_; }

 private:
  ompl::base::PlannerPtr planner_;
  double limit_s_;
  Preparation prepare_;
  std::function<void()> finish_;
  double elapsed_s_ = 0.0;
  std::string crash_;
};

}  // namespace b4p
