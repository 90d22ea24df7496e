// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "planners/b4p/statistics.h"
#include "planners/guarded_planner.h"
#include "planners/parallel_search.h"

namespace b4p {

/// What the parallel planners of this package have in common: the life cycle of an OMPL planner around a
/// ParallelSearch whose workers are stepped by a crew of threads.
///
/// With a PlaceGoal over a ManipulationStateSpace such a planner draws picks by itself; start states are
/// further ones and may be missing. Solutions are exact paths, there are no approximate ones. solve() may be
/// called again and continues the search there is; clear() forgets it. State validity checker, motion
/// validator and goal are called from all threads at a time (sampling of a plain goal one thread at a time).
class ParallelPlanner : public GuardedPlanner {
 public:
  void clear() override;

  /// @throws ompl::Exception when there is no problem definition, no goal, or, but for a PlaceGoal, no start
  /// state
  void checkValidity() override;

  /// Vertices are tagged 1 (pick side) or 2 (place side); edges point from pick to place, over junctions as
  /// well (those whose path was repaired left aside).
  void getPlannerData(ompl::base::PlannerData& data) const override;

 protected:
  ParallelPlanner(const ompl::base::SpaceInformationPtr& si, const std::string& name);

  virtual unsigned threadCount() const = 0;
  virtual std::unique_ptr<ParallelSearch> makeSearch(const SearchProblem& problem) = 0;

  /// What becomes of a path before it is a solution, inside the time limit: here nothing.
  virtual void shorten(ompl::geometric::PathGeometric& path,
                       const ompl::base::PlannerTerminationCondition& ptc) {
    static_cast<void>(path), static_cast<void>(ptc);
  }

  /// Lets workers 0 ... threadCount()-1 take steps until the search is `over` or `ptc` holds: here each in a
  /// thread of its own. What `step` throws passes through.
  virtual void work(const std::function<void(std::size_t number)>& step, const std::function<bool()>& over,
                    const ompl::base::PlannerTerminationCondition& ptc);

  /// Through which workers see what others have done; nullptr: at once.
  virtual PublicationLog* publicationLog() { return nullptr; }

  const Statistics& statistics() const { return statistics_; }

 private:
  ompl::base::PlannerStatus search(const ompl::base::PlannerTerminationCondition& ptc) override;
  void forget();
  void prepareSearch(const ompl::base::GoalSampleableRegion& goal);
  void beginSearch(const ompl::base::GoalSampleableRegion& goal);
  void hireWorkers();
  ompl::base::PlannerStatus plantRoots(const ompl::base::GoalSampleableRegion& goal,
                                       const ompl::base::PlannerTerminationCondition& ptc);
  void plantStarts();
  bool plantFirstGoal(const ompl::base::GoalSampleableRegion& goal,
                      const ompl::base::PlannerTerminationCondition& ptc);

  Statistics statistics_;
  ompl::base::ProblemDefinitionPtr problem_;  ///< what `search_` was made for
  ompl::base::GoalPtr goal_;
  std::unique_ptr<ParallelSearch> search_;
  std::vector<std::unique_ptr<ParallelWorker>> workers_;
};

/// A ParallelPlanner whose OMPL parameters are the fields of a plain struct. `threads` takes effect at the
/// next solve(), all others at the first solve() after construction or clear().
/// @tparam Parameters  has a field `threads`
template <class Parameters>
class ParametrisedPlanner : public WithParameters<ParallelPlanner, Parameters> {
 protected:
  using WithParameters<ParallelPlanner, Parameters>::WithParameters;

  unsigned threadCount() const override { return this->parameters().threads; }
};

}  // namespace b4p
