// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include <ompl/base/Planner.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/geometric/PathGeometric.h>

#include "planners/b4p/forest.h"
#include "planners/b4p/growth.h"
#include "planners/b4p/motion.h"
#include "planners/b4p/publication_log.h"
#include "planners/b4p/statistics.h"

namespace b4p {

/// What a search is about, and what it shares with the planner that it belongs to.
struct SearchProblem {
  ompl::base::SpaceInformationPtr si;
  const ompl::base::GoalSampleableRegion* goal;  ///< where the query ends; not null
  const PickPlaceRegion* region;  ///< the pick-and-place problem behind the goal, nullptr: there is none
  ompl::base::PlannerInputStates& inputs;  ///< start and goal states of the problem
  Statistics& statistics;                  ///< counts what is done
  /// When given, workers see through it what others have done; they then share one thread.
  PublicationLog* log = nullptr;
};

/// Does a search's work one step at a time. Each worker is used by one thread at a time, which need not be
/// always the same. A step takes as long as a few edge checks or inverse-kinematics calls.
class ParallelWorker {
 public:
  ParallelWorker() = default;
  virtual ~ParallelWorker() = default;
  ParallelWorker(const ParallelWorker&) = delete;
  ParallelWorker& operator=(const ParallelWorker&) = delete;

  /// One step. Does nothing once the search has finished. May throw what the problem's own functions throw.
  virtual void step() = 0;

  /// Lets others go on with what this worker has begun: it will not be stepped for a while.
  virtual void rest() {}
};

/// What the workers of one query share, whatever the planner: problem, roots, solution. Any thread may call
/// anything.
class ParallelSearch {
 public:
  explicit ParallelSearch(const SearchProblem& problem);
  virtual ~ParallelSearch() = default;
  ParallelSearch(const ParallelSearch&) = delete;
  ParallelSearch& operator=(const ParallelSearch&) = delete;

  /// A further worker.
  /// @param seed  of its draws from the pick-and-place region; the state sampler has OMPL's
  virtual std::unique_ptr<ParallelWorker> newWorker(std::uint64_t seed) = 0;

  /// Takes a start or goal state of the problem. False when it cannot be used or was there already.
  virtual bool addRoot(Side side, const ompl::base::State* root, GraspId grasp) = 0;

  /// solve() begins or ends: no worker steps in between.
  virtual void resume() {}
  virtual void pause() {}

  /// True when it is time for the planner to drop this search and begin another one, with all start states.
  virtual bool expired() const { return false; }

  virtual void forEachNode(const std::function<void(const Node&)>& visit) const = 0;

  const ompl::base::SpaceInformationPtr& si() const { return problem_.si; }
  const PickPlaceRegion* region() const { return problem_.region; }
  const GraspAccess& grasps() const { return grasps_; }
  Statistics& statistics() const { return problem_.statistics; }
  PublicationLog* log() const { return problem_.log; }

  std::size_t rootCount(Side side) const { return roots_[index(side)]; }

  /// Takes the next goal of a plain OMPL problem as a root. False when there is none now.
  bool plantGoal();

  /// True when the problem accepts a path between the roots of these nodes.
  bool rootsMatch(const Junction& junction) const;

  /// A finished path, or the one through a junction of two trees of one grasp. The first one ends the search.
  void publish(const Junction& junction);
  void publish(const ompl::geometric::PathGeometric& path);
  std::optional<ompl::geometric::PathGeometric> takeSolution();
  bool finished() const { return finished_.load(std::memory_order_acquire); }

  /// Junctions published so far whose trees are still there.
  std::vector<Junction> connections() const;

 protected:
  void countRoot(Side side) { ++roots_[index(side)]; }
  /// Before trees are dropped.
  void forgetConnections();

 private:
  void finish(const ompl::geometric::PathGeometric& path);

  const SearchProblem problem_;
  const GraspAccess grasps_;
  std::array<std::atomic<std::size_t>, 2> roots_{};

  std::mutex inputs_mutex_;

  mutable std::mutex solution_mutex_;
  std::vector<Junction> connections_;
  std::optional<ompl::geometric::PathGeometric> solution_;
  std::atomic<bool> finished_{false};
};

/// False when a value of the state is not finite.
bool allFinite(const ompl::base::StateSpace& space, const ompl::base::State* state);

}  // namespace b4p
