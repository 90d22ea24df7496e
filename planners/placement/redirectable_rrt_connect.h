// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "planners/guarded_planner.h"
#include "planners/placement/redirectable_search.h"
#include "planners/root_drawer.h"

namespace b4p {

/// Settings of RedirectableRRTConnect.
struct RedirectableParameters {
  double range = 0.0;    ///< longest motion added at once; 0: as far as it stays free
  unsigned slice = 100;  ///< iterations of one mode before the next one has its turn, >= 1

  /// Empty when all is in range, otherwise what is not.
  std::string problem() const;
};

/// RRT-Connect whose goals can be added and removed while its trees are kept: the motion planner of Haustein
/// et al., "Object Placement Planning and Optimization for Robot Manipulators" (IROS 2019), section IV-D.
///
/// Takes the goal states of any GoalSampleableRegion, and those given to addGoal() whatever the region says
/// of them. A path never ends at a removed goal, but may pass through what has grown from it. On a
/// ManipulationStateSpace each grasp has trees of its own, and grasps have turns of `slice` iterations. With
/// a PlaceGoal the planner draws picks and placements by itself, each round one more pick; start states are
/// further ones and may be missing.
///
/// One thread; solutions are exact paths, OMPL's global seed determines them. solve() may be called again and
/// goes on with the trees there are, towards goals not yet reached; when there are none it says again how the
/// reached ones that are left can be reached. clear() forgets all. Parameters take effect at the first use
/// after construction or clear(). Goals are added and removed between calls of solve().
class RedirectableRRTConnect : public WithParameters<GuardedPlanner, RedirectableParameters> {
 public:
  explicit RedirectableRRTConnect(const ompl::base::SpaceInformationPtr& si);

  /// Adds a goal. kNoGoal when the state is not valid; the id there is when it equals an open goal.
  /// @throws ompl::Exception without a problem definition and goal
  GoalId addGoal(const ompl::base::State* state);

  /// Removes a goal of any origin. False when there is none with this id.
  bool removeGoal(GoalId id);

  /// Goals that have not been removed, reached or not.
  std::vector<GoalId> goals() const;

  /// Which goal the last solution ends in; kNoGoal while there is none.
  GoalId reachedGoal() const { return reached_.empty() ? kNoGoal : last_reached_; }

  void clear() override;
  void checkValidity() override { checkValidityOfDrawnStarts(); }

  /// Vertices are tagged 1 (forward) or 2 (backward). Goals are those not removed.
  void getPlannerData(ompl::base::PlannerData& data) const override;

 private:
  ompl::base::PlannerStatus search(const ompl::base::PlannerTerminationCondition& ptc) override;
  void forget();
  void prepareSearch();
  void plantStarts();
  ompl::base::PlannerStatus plantGoals(const ompl::base::GoalSampleableRegion& goal,
                                       const ompl::base::PlannerTerminationCondition& ptc);
  void feed(const ompl::base::GoalSampleableRegion& goal);
  void drawRoots();
  bool plantGoal(const ompl::base::State* state);

  RedirectStatistics statistics_;
  ompl::base::ProblemDefinitionPtr problem_;  ///< what `search_` was made for
  ompl::base::GoalPtr goal_;
  std::unique_ptr<RedirectableSearch> search_;
  const PickPlaceRegion* region_ = nullptr;  ///< behind a PlaceGoal
  std::unique_ptr<RootDrawer> drawer_;       ///< of the region
  std::uint64_t fed_rounds_ = 0;
  std::vector<ReachedGoal> reached_;  ///< that have not been removed
  GoalId last_reached_ = kNoGoal;
};

}  // namespace b4p
