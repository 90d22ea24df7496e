// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <ompl/base/Planner.h>

#include "planners/b4p/parameters.h"
#include "planners/b4p/search.h"
#include "planners/b4p/statistics.h"
#include "planners/b4p/worker.h"

namespace b4p {

/// B4P (Leebron, Ren, Chen, Hang, IROS 2025): parallel workers grow forests of pick and place trees under
/// many grasps at once, join trees even of different grasps, re-derive the place root for the pick's grasp
/// and repair the path.
///
/// With a PlaceGoal over a ManipulationStateSpace it solves a whole pick-and-place query: which grasp, which
/// placement, which motion. It then draws pick roots itself; start states are further ones and may be
/// missing. On any other state space with any GoalSampleableRegion it is a parallel bidirectional planner
/// with many roots. A solution is an exact path whose every motion the problem's motion validator accepted;
/// there are no approximate ones.
///
/// solve() may be called again and continues with the forests there are; clear() forgets them. Parameters
/// other than `threads` take effect at the first solve() after construction or clear(). solve() never throws
/// but for a missing problem definition: an exception out of the problem's own functions ends in
/// PlannerStatus::CRASH. State validity checker, motion validator and goal are called from `threads` threads
/// at a time (sampling of a plain goal one thread at a time). With one thread, OMPL's global seed determines
/// the result.
class B4P : public ompl::base::Planner {
 public:
  explicit B4P(const ompl::base::SpaceInformationPtr& si);
  ~B4P() override;

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

  const B4PParameters& parameters() const { return parameters_; }

  /// @throws ompl::Exception naming what is out of range; nothing changes then.
  void setParameters(const B4PParameters& parameters);

 protected:
  /// Lets workers 0 ... threads-1 take steps until the search has finished or `ptc` holds: here each in a
  /// thread of its own. What `step` throws passes through.
  virtual void work(const std::function<void(std::size_t number)>& step,
                    const std::function<bool()>& finished,
                    const ompl::base::PlannerTerminationCondition& ptc);

  /// Through which workers see what others have done; nullptr: at once.
  virtual PublicationLog* publicationLog() { return nullptr; }

 private:
  template <class Value>
  void declare(const std::string& name, Value B4PParameters::*field, const std::string& range);
  void declareProgress(const std::string& name, const std::atomic<std::uint64_t>& count);

  ompl::base::PlannerStatus search(const ompl::base::PlannerTerminationCondition& ptc);
  void prepareSearch(ompl::base::GoalSampleableRegion* goal);
  void plantStarts();
  bool mayGiveMore(const ompl::base::GoalSampleableRegion& goal) const;
  bool plantFirstGoal(const ompl::base::GoalSampleableRegion& goal,
                      const ompl::base::PlannerTerminationCondition& ptc);
  void addSolution(const ompl::geometric::PathGeometric& path);

  B4PParameters parameters_;
  Statistics statistics_;
  std::string last_error_;
  ompl::base::ProblemDefinitionPtr problem_;  ///< what `search_` was made for
  ompl::base::GoalPtr goal_;
  std::unique_ptr<Search> search_;
  std::vector<std::unique_ptr<Worker>> workers_;
};

}  // namespace b4p
