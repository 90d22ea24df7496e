// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "planners/guarded_planner.h"
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
/// effect at the first solve() after construction or clear(). The robot's functions are among those whose
/// exceptions end in PlannerStatus::CRASH. Inverse kinematics counts inside the time limit. OMPL's global
/// seed determines the result.
class ReachPlanner : public GuardedPlanner {
 public:
  void clear() override;

  /// Vertices are tagged 1 (trees of starts) or 2 (goal configurations and their trees); edges point from
  /// start to goal. The property "grasp id INTEGER" is the grasp of the last solution, -1 without any.
  void getPlannerData(ompl::base::PlannerData& data) const override;

  /// The grasp that the last solution reaches, as ReachGoal::graspOf() says; kNoGrasp while there is none.
  GraspId solvedGrasp() const { return solved_grasp_; }

 protected:
  ReachPlanner(const ompl::base::SpaceInformationPtr& si, const std::string& name);

  virtual std::unique_ptr<ReachSearch> makeSearch(const ReachGoal& goal) = 0;

  ReachStatistics& statistics() { return statistics_; }

 private:
  ompl::base::PlannerStatus search(const ompl::base::PlannerTerminationCondition& ptc) override;
  void forget();
  void prepareSearch(const ReachGoal& goal);
  void plantStarts();

  ReachStatistics statistics_;
  ompl::base::ProblemDefinitionPtr problem_;  ///< what `search_` was made for
  ompl::base::GoalPtr goal_;
  std::unique_ptr<ReachSearch> search_;
  std::vector<Junction> connections_;  ///< of the solutions so far
  GraspId solved_grasp_ = kNoGrasp;
};

/// A ReachPlanner whose OMPL parameters are the fields of a plain struct.
template <class Parameters>
using ParametrisedReachPlanner = WithParameters<ReachPlanner, Parameters>;

}  // namespace b4p
