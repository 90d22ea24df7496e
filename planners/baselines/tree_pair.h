// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>

#include "planners/b4p/forest.h"
#include "planners/b4p/growth.h"
#include "planners/b4p/motion.h"
#include "planners/b4p/statistics.h"

namespace b4p {

/// The two trees of one grasp and one placement, which grow toward each other by RRT-Connect. It has its pick
/// root from the beginning, its place root as soon as one is found. Any number of threads may work on it.
class TreePair {
 public:
  /// @param statistics  counts its roots and nodes, for as long as it lives
  TreePair(const ompl::base::SpaceInformationPtr& si, const ompl::base::State* pick, GraspId grasp,
           Statistics& statistics);
  ~TreePair();
  TreePair(const TreePair&) = delete;
  TreePair& operator=(const TreePair&) = delete;

  GraspId grasp() const { return forests_.grasp(); }

  /// True once it has both roots.
  bool complete() const { return complete_.load(std::memory_order_acquire); }

  /// Sets the place root. The first one stays for good; others are ignored.
  void complete(const ompl::base::State* place, PlacementId placement);

  /// One iteration of RRT-Connect in which `side` grows first; the very first one goes straight from root to
  /// root. Only once complete. The junction when the trees met.
  std::optional<Junction> grow(Side side, Motion& motion);

  void countPlacementTried() { countOne(placements_tried_); }
  std::uint64_t placementsTried() const { return placements_tried_.load(std::memory_order_relaxed); }
  /// How often grow() was called.
  std::uint64_t iterations() const { return iterations_.load(std::memory_order_relaxed); }

  std::size_t nodeCount() const { return forests_.nodeCount(); }
  void forEachNode(const std::function<void(const Node&)>& visit) const { forests_.forEachNode(visit); }

 private:
  Tree* plant(Side side, const ompl::base::State* root, GraspId grasp, PlacementId placement);

  Statistics& statistics_;
  ForestPair forests_;
  std::mutex mutex_;  // one place root only
  std::array<Tree*, 2> trees_{};
  std::atomic<bool> complete_{false};
  std::atomic<std::uint64_t> placements_tried_{0}, iterations_{0};
};

}  // namespace b4p
