// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <ompl/geometric/PathGeometric.h>

#include "planners/b4p/forest.h"
#include "planners/b4p/motion.h"

namespace b4p {

/// A pick node and a place node between which the straight motion is free under the pick tree's grasp.
struct Junction {
  const Node* pick;
  const Node* place;
};

/// Where an expansion ended.
struct Expansion {
  const Node* node = nullptr;  ///< nullptr when it could not move
  bool reached = false;        ///< the node is at the target
  bool added = false;          ///< false when the target was in the tree already
};

/// Extends a tree from `near` towards `target` as far as the motion stays free (Algorithm 3, ExpandTree).
/// @tparam Forests  a ForestPair, or what has its grow()
template <class Forests>
Expansion expandFrom(Forests& forests, const Node* near, const ompl::base::State* target, Motion& motion) {
  if (motion.grasps().samePlace(near->state, target)) return {near, true, false};
  const Motion::Reach reach = motion.extend(near->state, target, near->tree->grasp, near->tree->side);
  if (reach == Motion::Reach::kTrapped) return {};
  return {forests.grow(near, motion.end()), reach == Motion::Reach::kReached, true};
}

/// Extends the tree nearest to `target` on one side (FindNearestTree and ExpandTree). Nothing while the side
/// has no tree.
/// @tparam Forests  a ForestPair, or what has its grow() and nearest()
template <class Forests>
Expansion expand(Forests& forests, Side side, const ompl::base::State* target, Motion& motion) {
  const Node* near = forests.nearest(side, target);
  return near == nullptr ? Expansion{} : expandFrom(forests, near, target, motion);
}

/// What one iteration of growAndConnect() led to.
struct Growth {
  const Node* grown = nullptr;       ///< where the side that grew has got to, if it moved
  std::optional<Junction> junction;  ///< set when the two sides met
  std::size_t nodes = 0;             ///< how many were added
};

/// One iteration of RRT-Connect on forests whose trees share a grasp: `side` grows toward `target`, the other
/// side then grows toward the new node.
/// @tparam Forests  see expand()
template <class Forests>
Growth growAndConnect(Forests& forests, Side side, const ompl::base::State* target, Motion& motion) {
  Growth growth;
  const Expansion expansion = expand(forests, side, target, motion);
  growth.grown = expansion.node;
  growth.nodes = expansion.added;
  if (growth.grown == nullptr) return growth;
  Expansion met = expand(forests, opposite(side), growth.grown->state, motion);
  growth.nodes += met.added;
  while (met.node != nullptr && !met.reached) {
    met = expandFrom(forests, met.node, growth.grown->state, motion);
    growth.nodes += met.added;
  }
  if (met.reached)
    growth.junction =
        side == Side::kPick ? Junction{growth.grown, met.node} : Junction{met.node, growth.grown};
  return growth;
}

/// A path from a pick root over a junction to a place root.
struct JoinedPath {
  ompl::geometric::PathGeometric path;
  std::size_t junction;  ///< index of the junction's pick node: up to it all motions are known to be free
};

/// The path has both roots, all states set to the grasp of the pick tree; a state that repeats is left out.
JoinedPath pathThrough(const Junction& junction, const ompl::base::SpaceInformationPtr& si);

}  // namespace b4p
