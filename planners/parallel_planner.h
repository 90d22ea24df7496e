// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <ompl/base/Planner.h>
#include <ompl/util/Exception.h>

#include "planners/b4p/statistics.h"
#include "planners/parallel_search.h"

namespace b4p {

/// What the parallel planners of this package have in common: the life cycle of an OMPL planner around a
/// ParallelSearch whose workers are stepped by a crew of threads.
///
/// With a PlaceGoal over a ManipulationStateSpace such a planner draws picks by itself; start states are
/// further ones and may be missing. Solutions are exact paths, there are no approximate ones. solve() may be
/// called again and continues the search there is; clear() forgets it. solve() never throws but for a missing
/// problem definition: an exception out of the problem's own functions ends in PlannerStatus::CRASH. State
/// validity checker, motion validator and goal are called from all threads at a time (sampling of a plain
/// goal one thread at a time).
class ParallelPlanner : public ompl::base::Planner {
 public:
  using Planner::solve;
  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& ptc) override;
  void clear() override;

  /// @throws ompl::Exception when there is no problem definition, no goal, or, but for a PlaceGoal, no start
  /// state
  void checkValidity() override;

  /// Vertices are tagged 1 (pick side) or 2 (place side); edges point from pick to place, over junctions as
  /// well (those whose path was repaired left aside).
  void getPlannerData(ompl::base::PlannerData& data) const override;

  /// What ended the last solve() with PlannerStatus::CRASH; empty when nothing did.
  const std::string& lastError() const { return last_error_; }

 protected:
  ParallelPlanner(const ompl::base::SpaceInformationPtr& si, const std::string& name);

  virtual unsigned threadCount() const = 0;
  virtual std::unique_ptr<ParallelSearch> makeSearch(const SearchProblem& problem) = 0;

  /// @param count  a member of statistics()
  void declareProgress(const std::string& name, const std::atomic<std::uint64_t>& count);
  const Statistics& statistics() const { return statistics_; }

 private:
  ompl::base::PlannerStatus search(const ompl::base::PlannerTerminationCondition& ptc);
  void forget();
  void prepareSearch(const ompl::base::GoalSampleableRegion& goal);
  void beginSearch(const ompl::base::GoalSampleableRegion& goal);
  void hireWorkers();
  ompl::base::PlannerStatus plantRoots(const ompl::base::GoalSampleableRegion& goal,
                                       const ompl::base::PlannerTerminationCondition& ptc);
  void plantStarts();
  bool mayGiveMore(const ompl::base::GoalSampleableRegion& goal) const;
  bool plantFirstGoal(const ompl::base::GoalSampleableRegion& goal,
                      const ompl::base::PlannerTerminationCondition& ptc);
  void work(const ompl::base::PlannerTerminationCondition& ptc);
  void addSolution(const ompl::geometric::PathGeometric& path);

  Statistics statistics_;
  std::string last_error_;
  ompl::base::ProblemDefinitionPtr problem_;  ///< what `search_` was made for
  ompl::base::GoalPtr goal_;
  std::unique_ptr<ParallelSearch> search_;
  std::vector<std::unique_ptr<ParallelWorker>> workers_;
};

/// A ParallelPlanner whose OMPL parameters are the fields of a plain struct.
/// @tparam Parameters  has a field `threads`, and problem(): what is out of range, "" when nothing is
template <class Parameters>
class ParametrisedPlanner : public ParallelPlanner {
 public:
  const Parameters& parameters() const { return parameters_; }

  /// `threads` takes effect at the next solve(), all others at the first solve() after construction or
  /// clear().
  /// @throws ompl::Exception naming what is out of range; nothing changes then.
  void setParameters(const Parameters& parameters) {
    const std::string problem = parameters.problem();
    if (!problem.empty()) throw ompl::Exception(getName(), problem);
    parameters_ = parameters;
  }

 protected:
  using ParallelPlanner::ParallelPlanner;

  /// @tparam Owner  Parameters or a base of it
  template <class Value, class Owner>
  void declare(const std::string& name, Value Owner::*field, const std::string& range) {
    const auto set = [this, field](Value value) {
      Parameters changed = parameters_;
      changed.*field = value;
      setParameters(changed);
    };
    params_.declareParam<Value>(name, set, [this, field] { return parameters_.*field; });
    params_[name].setRangeSuggestion(range);
  }

  unsigned threadCount() const override { return parameters_.threads; }

 private:
  Parameters parameters_;
};

}  // namespace b4p
