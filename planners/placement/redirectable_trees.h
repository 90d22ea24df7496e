// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <ompl/base/SpaceInformation.h>
#include <ompl/datastructures/NearestNeighborsGNAT.h>

#include "planners/b4p/forest.h"
#include "planners/b4p/growth.h"

namespace b4p {

/// Numbers a goal of a redirectable search.
using GoalId = std::int64_t;
constexpr GoalId kNoGoal = -1;

/// A goal's node in a forward tree.
struct ReachedGoal {
  GoalId id;
  const Node* node;
};

/// The trees of one mode, after Haustein et al. (IROS 2019, section IV-D): forward trees from the starts and
/// one backward tree per goal. A goal may be removed: its tree stays. When a forward and a backward tree
/// meet, they become one forward tree, whether or not the backward tree still has its goal. For one thread.
class RedirectableTrees {
 public:
  RedirectableTrees(ompl::base::SpaceInformationPtr si, const StateDistance& distance, GraspId grasp);
  ~RedirectableTrees();
  RedirectableTrees(const RedirectableTrees&) = delete;
  RedirectableTrees& operator=(const RedirectableTrees&) = delete;

  GraspId grasp() const { return grasp_; }

  /// Starts a forward tree from a copy of `root`. False when there is an equal one.
  bool addStart(const ompl::base::State* root);

  /// Makes `root` a goal, in the backward tree that has this root or in another one.
  /// @return `id`, or the id of an equal goal that there is
  GoalId addGoal(GoalId id, const ompl::base::State* root);

  /// Its tree is a mere way from now on. False when there is no such goal any more.
  bool removeGoal(GoalId id);

  bool hasStarts() const { return !forward_.empty(); }
  std::vector<GoalId> goals() const;  ///< that have neither been removed nor reached
  std::size_t goalCount() const { return goals_; }
  const Node* goalRoot(GoalId id) const;  ///< nullptr when there is no such goal any more

  /// Node of one side, nullptr while it has none. In the metric of the mode.
  const Node* nearest(Side side, const ompl::base::State* state) const;

  /// Adds a copy of `state` below `parent`.
  const Node* grow(const Node* parent, const ompl::base::State* state);

  /// The goal behind a junction's backward tree; kNoGoal when it has none any more.
  GoalId goalOf(const Junction& junction) const;

  /// Makes one forward tree of the two that meet: the backward one is rooted anew where they meet, and all
  /// its nodes join. Where motions have a direction (StateSpace::hasSymmetricInterpolate() is false) only the
  /// way to its root can be gone forward: that way joins, the rest is used no longer.
  /// @return the goal that has been reached, when the backward tree still had one
  std::optional<ReachedGoal> merge(const Junction& junction);

  std::size_t nodeCount() const { return storage_.size(); }
  std::size_t backwardNodeCount() const { return backward_nodes_; }
  void forEachNode(const std::function<void(const Node&)>& visit) const;

 private:
  using Index = ompl::NearestNeighborsGNAT<const Node*>;

  struct RootedTree : Tree {
    std::shared_ptr<Index> nodes;  ///< several forward trees may share one
    GoalId goal = kNoGoal;
  };

  static RootedTree& treeOf(const Node* node) { return *static_cast<RootedTree*>(node->tree); }

  RootedTree& plant(Side side, const ompl::base::State* root);
  RootedTree* findBackward(const ompl::base::State* root);
  RootedTree* findGoal(GoalId id) const;
  void shareIndex(RootedTree& joining, RootedTree& forward);

  ompl::base::SpaceInformationPtr si_;
  StateDistance distance_;
  GraspId grasp_;
  bool symmetric_;
  std::deque<Node> storage_;
  std::deque<RootedTree> trees_;
  std::vector<std::shared_ptr<Index>> forward_;
  std::vector<RootedTree*> backward_;
  std::size_t backward_nodes_ = 0;
  std::size_t goals_ = 0;
};

/// The path from a forward root to a node of its tree. Ends exactly in the node's state and has at least two
/// states.
ompl::geometric::PathGeometric pathTo(const Node& node, const ompl::base::SpaceInformationPtr& si);

}  // namespace b4p
