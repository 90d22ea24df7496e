// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include <ompl/base/SpaceInformation.h>

#include "planners/b4p/forest.h"
#include "planners/b4p/growth.h"
#include "planners/b4p/motion.h"
#include "planners/b4p/statistics.h"
#include "planners/reach/reach_goal.h"

namespace b4p {

/// What a reach planner has done so far. Written by the planner, read from any thread.
struct ReachStatistics {
  std::atomic<std::uint64_t> iterations{0};
  std::atomic<std::uint64_t> nodes{0};
  std::atomic<std::uint64_t> grasps_tried{0};  ///< a grasp counts each time it is chosen
  std::atomic<std::uint64_t> ik_attempts{0};
  std::atomic<std::uint64_t> goal_roots{0};

  void reset() {
    for (auto* count : {&iterations, &nodes, &grasps_tried, &ik_attempts, &goal_roots}) count->store(0);
  }
};

/// One query of a reach planner: what it has grown so far, on one thread. The trees of starts are pick trees,
/// those of goal configurations place trees whose `placement` is the grasp.
class ReachSearch {
 public:
  /// @param goal, statistics  have to outlive the search
  /// @param distance  chooses the nearest node
  /// @param range     longest motion added at once, in the metric of the space; 0: as far as it stays free
  ReachSearch(const ompl::base::SpaceInformationPtr& si, const ReachGoal& goal, const StateDistance& distance,
              double range, ReachStatistics& statistics);
  virtual ~ReachSearch() = default;
  ReachSearch(const ReachSearch&) = delete;
  ReachSearch& operator=(const ReachSearch&) = delete;

  const ReachGoal& goal() const { return goal_; }

  /// Starts a tree from a start state. False when it has a tree already.
  bool plantStart(const ompl::base::State* start);

  /// A start planted since the last call that is in the goal already, if any: a path of no motion.
  std::optional<Junction> startInGoal();

  /// One iteration. Where the trees of a start and of a goal configuration meet, if they do.
  virtual std::optional<Junction> step() = 0;

  ForestPair& forests() { return forests_; }

 protected:
  virtual void startPlanted(const Node*) {}

  /// The root of a tree from a goal configuration, whether planted now or before.
  const Node* plantGoal(const ompl::base::State* state, GraspId grasp);

  const JointSpace& joints() const { return goal_.joints(); }
  const ompl::base::SpaceInformationPtr& si() const { return si_; }
  Motion& motion() { return motion_; }
  ReachStatistics& statistics() { return statistics_; }

 private:
  ompl::base::SpaceInformationPtr si_;
  const ReachGoal& goal_;
  ForestPair forests_;
  Motion motion_;
  ReachStatistics& statistics_;
  std::optional<Junction> start_in_goal_;
};

}  // namespace b4p
