// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <vector>

#include <ompl/base/ScopedState.h>

#include "planners/b4p/motion.h"
#include "planners/baselines/tree_pair.h"
#include "planners/parallel_search.h"
#include "planners/root_drawer.h"

namespace b4p {

/// What the workers of a baseline share on a pick-and-place problem: the pairs of trees there are, and the
/// picks that the problem gave as start states. Any thread may call anything.
class PairSearch : public ParallelSearch {
 public:
  using ParallelSearch::ParallelSearch;

  bool addRoot(Side side, const ompl::base::State* root, GraspId grasp) override;

  /// A new pair with a pick given by the problem, each once and in their order; nullptr when none is left.
  std::shared_ptr<TreePair> takeGivenPick();

  /// A new pair with this pick.
  std::shared_ptr<TreePair> addPair(const ompl::base::State* pick, GraspId grasp);

  /// Drops a pair; its trees go with the last worker that still uses them.
  void drop(const std::shared_ptr<TreePair>& pair);

  /// The trees of a pair have met.
  virtual void connected(const TreePair&, const Junction& junction) { publish(junction); }

  std::vector<std::shared_ptr<const TreePair>> pairs() const;  ///< a snapshot, in the order they came
  void forEachNode(const std::function<void(const Node&)>& visit) const override;

 private:
  mutable std::mutex mutex_;  // guards what follows
  std::deque<ompl::base::ScopedState<>> given_;
  std::vector<std::shared_ptr<TreePair>> pairs_;
};

/// A worker of a baseline on a pick-and-place problem.
class PairWorker : public ParallelWorker {
 public:
  /// @param range  see Motion
  PairWorker(PairSearch& search, double range, std::uint64_t seed);

  void step() final;

 protected:
  virtual void advance() = 0;

  /// Draws a grasp and its pick: a new pair, or nullptr when this draw gave nothing.
  std::shared_ptr<TreePair> drawPick();

  /// Draws one placement. If it has a place root for the pair's grasp (Eq. 3), the pair is complete with it.
  /// Whether the pair is complete.
  bool seekPlacement(TreePair& pair);

  /// One iteration of RRT-Connect on a complete pair, the two sides in turn.
  void grow(TreePair& pair);

 private:
  PlacementId drawPlacement();

  PairSearch& search_;
  Motion motion_;
  RootDrawer drawer_;
  Side next_side_ = Side::kPick;
  std::vector<PlacementId> placements_;  ///< drawn so far
};

}  // namespace b4p
