// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include <ompl/geometric/PathGeometric.h>

#include "planners/guarded_planner.h"
#include "planners/placement/local_optimiser.h"
#include "planners/placement/placement_goal.h"
#include "planners/placement/placement_path_objective.h"
#include "planners/placement/redirectable_search.h"

namespace b4p {

/// Settings of PlacementPlanner.
struct PlacementPlannerParameters {
  double range = 0.0;         ///< longest motion added at once; 0: as far as it stays free
  unsigned slice = 20;        ///< iterations of motion planning of one arm before the next has its turn, >= 1
  unsigned iterations = 100;  ///< of motion planning, all arms together, between two samplings of goals, >= 1
  unsigned draws = 200;       ///< placements drawn at most per sampling, which ends at the first goal, >= 1
  unsigned shortcuts = 20;    ///< tried on a path before it is published, see takeShortcuts(); 0: none
  bool local = true;          ///< whether placements that have been reached are improved locally
  double local_step = 0.01;   ///< see LocalOptimisation::step
  unsigned local_steps = 100;  ///< see LocalOptimisation::steps

  /// Empty when all is in range, otherwise what is not.
  std::string problem() const;
};

/// Anytime planner of motions to ever better placements: Haustein et al., "Object Placement Planning and
/// Optimization for Robot Manipulators" (IROS 2019), Algorithm 1.
///
/// The goal has to be a PlacementGoal over the planner's ManipulationStateSpace; each start state is an arm's
/// configuration, and an arm without one is not used. The planner samples goals above the best objective so
/// far, moves towards all of them at once (RedirectableSearch), improves what it reaches (LocalOptimiser),
/// and drops the goals that are then no better. Each improvement goes at once to the problem definition,
/// where a PlacementPathObjective ranks it first, and to its intermediate solution callback. Paths are
/// shortened by a bounded number of attempts before; a path's last state has the objective that the
/// solution's cost claims.
///
/// solve() ends at its termination condition, when an objective of the problem definition (a
/// PlacementPathObjective) is satisfied, or when the goal knows that nothing better is left; with
/// EXACT_SOLUTION when any placement was found, in this call or an earlier one. It may be called again and
/// goes on. An exception out of world or objective ends in CRASH, a goal without anything to place on in
/// INVALID_GOAL. A new problem and clear() forget everything and set the goal's threshold to what it was.
/// One thread; OMPL's global seed determines the result, by way of PlacementGoal::seed().
class PlacementPlanner : public WithParameters<GuardedPlanner, PlacementPlannerParameters> {
 public:
  explicit PlacementPlanner(const ompl::base::SpaceInformationPtr& si);

  void clear() override;

  /// Vertices are tagged 1 (forward) or 2 (backward). Goals are those still to be reached, and the best one.
  void getPlannerData(ompl::base::PlannerData& data) const override;

  /// Of the best placement so far; -infinity while there is none. Any thread may ask.
  double bestObjective() const { return best_.load(std::memory_order_acquire); }

 private:
  ompl::base::PlannerStatus search(const ompl::base::PlannerTerminationCondition& ptc) override;
  void forget();
  void prepareSearch(const std::shared_ptr<PlacementGoal>& goal);
  void plantStarts();
  bool sampleGoal(const ompl::base::PlannerTerminationCondition& ptc);
  std::optional<ReachedGoal> planMotion(const ompl::base::PlannerTerminationCondition& ptc);
  void take(const ReachedGoal& reached, const ompl::base::PlannerTerminationCondition& ptc);
  void publish(const ompl::geometric::PathGeometric& path, double objective);
  void dropGoalsNoBetter();
  std::string problem() const;
  ompl::base::PlannerStatus status() const;

  RedirectStatistics statistics_;
  std::atomic<std::uint64_t> draws_{0}, improvements_{0}, local_steps_{0};
  std::atomic<double> best_{-std::numeric_limits<double>::infinity()};
  ompl::base::ProblemDefinitionPtr problem_;  ///< what `search_` was made for
  std::shared_ptr<PlacementGoal> goal_;
  double threshold_before_ = 0.0;  ///< of the goal, when the search began
  std::shared_ptr<PlacementPathObjective> ranking_;
  std::unique_ptr<RedirectableSearch> search_;
  unsigned starts_seen_ = 0;  ///< of the problem definition
  std::unique_ptr<LocalOptimiser> local_;
  std::map<GoalId, double> objectives_;  ///< of open goals
  std::optional<ompl::geometric::PathGeometric> best_path_;
};

}  // namespace b4p
