// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <ompl/base/Planner.h>
#include <ompl/util/Exception.h>

#include "planners/reach/reach_goal.h"
#include "planners/reach/reach_search.h"

namespace b4p {

/// What JPlusRRT, IKRRT and BIKRRT have in common: the life cycle of an OMPL planner around a ReachSearch, on
/// one thread.
///
/// The goal has to be a ReachGoal (other goals: UNRECOGNIZED_GOAL_TYPE) over the planner's own state space
/// (others: INVALID_GOAL). A solution is an exact path whose every motion the problem's motion validator
/// accepted and whose last state is within the tolerance of a grasp: ReachGoal::graspOf() says which.
/// There are no approximate ones. Grasps out of reach end in TIMEOUT.
///
/// solve() may be called again and continues with the trees there are; clear() forgets them. Parameters take
/// effect at the first solve() after construction or clear(). solve() never throws but for a missing problem
/// definition, goal or start: an exception out of the problem's own functions, the robot's among them, ends
/// in PlannerStatus::CRASH. Inverse kinematics counts inside the time limit. OMPL's global seed determines
/// the result.
class ReachPlanner : public ompl::base::Planner {
 public:
  using Planner::solve;
  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& ptc) override;
  void clear() override;

  /// Vertices are tagged 1 (trees of starts) or 2 (goal configurations and their trees); edges point from
  /// start to goal. The property "grasp id INTEGER" is the grasp of the last solution, -1 without any.
  void getPlannerData(ompl::base::PlannerData& data) const override;

  /// The grasp that the last solution reaches; kNoGrasp while there is none.
  GraspId solvedGrasp() const;

  /// What ended the last solve() with PlannerStatus::CRASH; empty when nothing did.
  const std::string& lastError() const { return last_error_; }

 protected:
  ReachPlanner(const ompl::base::SpaceInformationPtr& si, const std::string& name);

  virtual std::unique_ptr<ReachSearch> makeSearch(const ReachGoal& goal) = 0;

  /// @param count  a member of statistics()
  void declareProgress(const std::string& name, const std::atomic<std::uint64_t>& count);
  ReachStatistics& statistics() { return statistics_; }

 private:
  ompl::base::PlannerStatus search(const ompl::base::PlannerTerminationCondition& ptc);
  void prepareSearch(const ReachGoal& goal);
  void plantStarts();
  void addSolution(const Junction& junction);

  ReachStatistics statistics_;
  std::string last_error_;
  ompl::base::ProblemDefinitionPtr problem_;  ///< what `search_` was made for
  ompl::base::GoalPtr goal_;
  std::unique_ptr<ReachSearch> search_;
  std::vector<Junction> connections_;  ///< of the solutions so far
};

/// A ReachPlanner whose OMPL parameters are the fields of a plain struct.
/// @tparam Parameters  has problem(): what is out of range, "" when nothing is
template <class Parameters>
class ParametrisedReachPlanner : public ReachPlanner {
 public:
  const Parameters& parameters() const { return parameters_; }

  /// @throws ompl::Exception naming what is out of range; nothing changes then.
  void setParameters(const Parameters& parameters) {
    const std::string problem = parameters.problem();
    if (!problem.empty()) throw ompl::Exception(getName(), problem);
    parameters_ = parameters;
  }

 protected:
  using ReachPlanner::ReachPlanner;

  template <class Value>
  void declare(const std::string& name, Value Parameters::*field, const std::string& range) {
    const auto set = [this, field](Value value) {
      Parameters changed = parameters_;
      changed.*field = value;
      setParameters(changed);
    };
    params_.declareParam<Value>(name, set, [this, field] { return parameters_.*field; });
    params_[name].setRangeSuggestion(range);
  }

 private:
  Parameters parameters_;
};

}  // namespace b4p
