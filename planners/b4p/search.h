// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <deque>
#include <map>
#include <memory>
#include <mutex>

#include "planners/b4p/connection_memory.h"
#include "planners/b4p/forest.h"
#include "planners/b4p/parameters.h"
#include "planners/b4p/path_repair.h"
#include "planners/b4p/schedule.h"
#include "planners/parallel_search.h"

namespace b4p {

/// Everything the workers of one query of B4P share. Any thread may call anything.
class Search : public ParallelSearch {
 public:
  Search(const SearchProblem& problem, const B4PParameters& parameters)
      : ParallelSearch(problem),
        parameters_(parameters),
        iterations_before_(problem.statistics.iterations),
        everywhere_{NodeIndex(grasps().distance(), log()), NodeIndex(grasps().distance(), log())} {}

  std::unique_ptr<ParallelWorker> newWorker(std::uint64_t seed) override;

  bool addRoot(Side side, const ompl::base::State* root, GraspId grasp) override {
    return plant(side, root, grasp) != nullptr;
  }

  /// Paper mode: after `restart_iterations` of all workers together.
  bool expired() const override {
    return parameters_.paper && parameters_.restart_iterations > 0 &&
           statistics().iterations - iterations_before_ >= parameters_.restart_iterations;
  }

  const B4PParameters& parameters() const { return parameters_; }
  Schedule& schedule() { return schedule_; }
  ConnectionMemory& memory() { return memory_; }

  /// The forests in which a tree of this grasp grows: one pair per grasp, or one for all grasps in paper
  /// mode.
  ForestPair& forestsOf(GraspId grasp);

  /// Forests that have a pick root and no place root yet, each in turn; nullptr when there are none.
  ForestPair* nextUnplaced();

  /// The single pair of paper mode.
  ForestPair& commonForests() { return forestsOf(kNoGrasp); }

  /// Plants a root; nullptr when the same root is there already (picks: up to what inverse kinematics tells
  /// apart), or a value is not finite.
  Tree* plant(Side side, const ompl::base::State* root, GraspId grasp, PlacementId placement = kNoPlacement);

  /// How many roots have been offered to plant(), those that were there already included.
  std::size_t rootsOffered(Side side) const { return offered_[index(side)]; }

  /// Nearest node of a side over the forests of all grasps; nullptr while there is none.
  const Node* nearestAnywhere(Side side, const ompl::base::State* state) const {
    return everywhere_[index(side)].nearest(state);
  }

  /// A repair that all workers take part in from now on; those submitted earlier come first.
  void submit(std::shared_ptr<PathRepair> repair);
  /// The repair under way, if any.
  std::shared_ptr<PathRepair> repair();
  /// Removes a repair that has ended. True for the one caller that removed it.
  bool retire(const std::shared_ptr<PathRepair>& repair);
  std::size_t repairCount() const { return repairs_waiting_.load(std::memory_order_relaxed); }

  void forEachNode(const std::function<void(const Node&)>& visit) const override;

 private:
  bool pickIsPlanted(const ompl::base::State* root, GraspId grasp);
  void scheduleIfComplete(ForestPair& forests);

  const B4PParameters parameters_;
  const std::uint64_t iterations_before_;  ///< those of searches that were restarted
  Schedule schedule_;
  ConnectionMemory memory_;
  std::array<NodeIndex, 2> everywhere_;
  std::array<std::atomic<std::size_t>, 2> offered_{};

  mutable std::mutex forests_mutex_;
  std::map<GraspId, std::unique_ptr<ForestPair>> forests_;
  std::deque<ForestPair*> incomplete_;  ///< a side has no root yet

  std::mutex repairs_mutex_;
  std::deque<std::shared_ptr<PathRepair>> repairs_;
  std::atomic<std::size_t> repairs_waiting_{0};
};

}  // namespace b4p
