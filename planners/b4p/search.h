// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include <ompl/base/Planner.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/geometric/PathGeometric.h>

#include "planners/b4p/connection_memory.h"
#include "planners/b4p/forest.h"
#include "planners/b4p/parameters.h"
#include "planners/b4p/path_repair.h"
#include "planners/b4p/publication_log.h"
#include "planners/b4p/schedule.h"
#include "planners/b4p/statistics.h"

namespace b4p {

/// Everything the workers of one query share. Any thread may call anything.
class Search {
 public:
  /// @param goal    where the query ends; not null
  /// @param region  the pick-and-place problem behind the goal, or nullptr on a plain OMPL problem
  /// @param inputs      start and goal states of the problem
  /// @param statistics  counts what is done
  /// @param log         when given, workers see through it what others have done; they then share one thread
  Search(ompl::base::SpaceInformationPtr si, const B4PParameters& parameters,
         const ompl::base::GoalSampleableRegion* goal, const PickPlaceRegion* region,
         ompl::base::PlannerInputStates& inputs, Statistics& statistics, PublicationLog* log = nullptr);

  const ompl::base::SpaceInformationPtr& si() const { return si_; }
  const B4PParameters& parameters() const { return parameters_; }
  const PickPlaceRegion* region() const { return region_; }
  const GraspAccess& grasps() const { return grasps_; }
  Statistics& statistics() { return statistics_; }
  Schedule& schedule() { return schedule_; }
  ConnectionMemory& memory() { return memory_; }
  PublicationLog* log() { return log_; }

  /// The forests in which a tree of this grasp grows: one pair per grasp, or one for all grasps in paper
  /// mode.
  ForestPair& forestsOf(GraspId grasp);

  /// The single pair of paper mode.
  ForestPair& commonForests() { return forestsOf(kNoGrasp); }

  /// Plants a root; nullptr when the same root is there already (picks: up to what inverse kinematics tells
  /// apart), or a value is not finite.
  Tree* plant(Side side, const ompl::base::State* root, GraspId grasp, PlacementId placement = kNoPlacement);

  std::size_t rootCount(Side side) const { return roots_[index(side)]; }

  /// How many roots have been offered to plant(), those that were there already included.
  std::size_t rootsOffered(Side side) const { return offered_[index(side)]; }

  /// Takes the next goal of a plain OMPL problem as a root. False when there is none now.
  bool plantGoal();

  /// Nearest node of a side over the forests of all grasps; nullptr while there is none.
  const Node* nearestAnywhere(Side side, const ompl::base::State* state) const {
    return everywhere_[index(side)].nearest(state);
  }

  /// True when the problem accepts a path between the roots of these nodes.
  bool rootsMatch(const Junction& junction) const;

  /// A finished path, or the one through a junction of two trees of one grasp. The first one ends the search.
  void publish(const Junction& junction);
  void publish(const ompl::geometric::PathGeometric& path);
  std::optional<ompl::geometric::PathGeometric> takeSolution();
  /// Junctions published so far.
  std::vector<Junction> connections() const;
  bool finished() const { return finished_.load(std::memory_order_acquire); }

  /// A repair that all workers take part in from now on; those submitted earlier come first.
  void submit(std::shared_ptr<PathRepair> repair);
  /// The repair under way, if any.
  std::shared_ptr<PathRepair> repair();
  /// Removes a repair that has ended. True for the one caller that removed it.
  bool retire(const std::shared_ptr<PathRepair>& repair);
  std::size_t repairCount() const { return repairs_waiting_.load(std::memory_order_relaxed); }

  void forEachNode(const std::function<void(const Node&)>& visit) const;

 private:
  bool pickIsPlanted(const ompl::base::State* root, GraspId grasp);
  void finish(const ompl::geometric::PathGeometric& path);

  const ompl::base::SpaceInformationPtr si_;
  const B4PParameters parameters_;
  const ompl::base::GoalSampleableRegion* const goal_;
  const PickPlaceRegion* const region_;
  const GraspAccess grasps_;
  ompl::base::PlannerInputStates& inputs_;
  Statistics& statistics_;
  PublicationLog* const log_;
  Schedule schedule_;
  ConnectionMemory memory_;
  std::array<NodeIndex, 2> everywhere_;
  std::array<std::atomic<std::size_t>, 2> roots_{}, offered_{};

  mutable std::mutex forests_mutex_;
  std::map<GraspId, std::unique_ptr<ForestPair>> forests_;

  std::mutex inputs_mutex_;

  mutable std::mutex solution_mutex_;
  std::vector<Junction> connections_;
  std::optional<ompl::geometric::PathGeometric> solution_;
  std::atomic<bool> finished_{false};

  std::mutex repairs_mutex_;
  std::deque<std::shared_ptr<PathRepair>> repairs_;
  std::atomic<std::size_t> repairs_waiting_{0};
};

}  // namespace b4p
