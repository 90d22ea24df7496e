// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "planners/b4p/motion.h"
#include "planners/placement/redirectable_trees.h"

namespace b4p {

/// What a redirectable search has done so far. Written by the search, read from any thread.
struct RedirectStatistics {
  std::atomic<std::uint64_t> iterations{0};
  std::atomic<std::uint64_t> nodes{0};
  std::atomic<std::uint64_t> goals{0};   ///< added, whatever became of them
  std::atomic<std::uint64_t> merges{0};  ///< of a backward tree into a forward one

  void reset() {
    for (auto* count : {&iterations, &nodes, &goals, &merges}) count->store(0);
  }
};

/// Bidirectional RRT-Connect whose goals may be added and removed while its trees are kept (Haustein et al.,
/// IROS 2019, section IV-D), in all modes of a problem: a mode is the grasp (or arm and grasp) that a state
/// carries, and each has trees of its own. The modes that have a start and a goal grow in turn, in slices of
/// equally many iterations. For one thread.
class RedirectableSearch {
 public:
  /// Whether a path may lead from a start to a goal.
  using PairFilter = std::function<bool(const ompl::base::State* start, const ompl::base::State* goal)>;

  /// @param range  longest motion added at once, in the metric of the space without grasps; 0: as far as it
  ///               stays free
  /// @param slice  iterations before the next mode has its turn, >= 1
  /// @param statistics  has to outlive the search
  RedirectableSearch(const ompl::base::SpaceInformationPtr& si, double range, unsigned slice,
                     PairFilter pairs, RedirectStatistics& statistics);

  /// False when there is an equal start. The state has to be valid.
  bool addStart(const ompl::base::State* start);

  /// Adds a goal in the mode of the state, which has to be valid. An equal goal that there is keeps its id.
  GoalId addGoal(const ompl::base::State* goal);

  /// A goal that has been reached is open again, with its id and a tree of its own.
  void reopen(const ReachedGoal& goal);

  /// The search no longer ends there; what has grown from it remains a way. False when there is no such goal.
  bool removeGoal(GoalId id);

  std::vector<GoalId> goals() const;                    ///< open: neither removed nor reached
  const ompl::base::State* goalState(GoalId id) const;  ///< of an open goal; nullptr: there is none
  std::size_t goalCount() const;                        ///< of open ones

  /// True when no mode has both a start and an open goal: step() can do nothing.
  bool idle() const;

  /// One iteration. A goal that has been reached by it, if any: it is then no longer open.
  std::optional<ReachedGoal> step();

  /// How often every mode has had its slice.
  std::uint64_t rounds() const { return rounds_; }

  std::size_t startModeCount() const;                   ///< modes that have a start
  std::vector<const RedirectableTrees*> modes() const;  ///< in the order in which they came
  void forEachNode(const std::function<void(const Node&)>& visit) const;

 private:
  struct Mode {
    Mode(const ompl::base::SpaceInformationPtr& si, const StateDistance& distance, GraspId grasp)
        : trees(si, distance, grasp) {}
    bool idle() const { return !trees.hasStarts() || trees.goalCount() == 0; }

    RedirectableTrees trees;
    std::deque<GoalId> straight;  ///< goals to which the straight way is still to be tried
    Side next_side = Side::kPick;
  };

  Mode& modeOf(const ompl::base::State* state);
  const Mode* modeOf(GoalId id) const;
  GoalId plantGoal(GoalId id, const ompl::base::State* root);
  Mode& modeForStep();
  std::optional<ReachedGoal> grow(Mode& mode);

  ompl::base::SpaceInformationPtr si_;
  const unsigned slice_;
  const PairFilter pairs_;
  RedirectStatistics& statistics_;
  Motion motion_;
  std::vector<std::unique_ptr<Mode>> modes_;
  std::size_t turn_ = 0;
  unsigned steps_in_turn_ = 0;
  std::uint64_t rounds_ = 0;
  GoalId next_goal_ = 0;
};

}  // namespace b4p
