// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
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
  bool blocked = false;        ///< something is in the way to the target
};

/// Extends a tree from `near` towards `target` as far as the motion stays free (Algorithm 3, ExpandTree).
/// @tparam Forests  a ForestPair, or what has its grow()
template <class Forests>
Expansion expandFrom(Forests& forests, const Node* near, const ompl::base::State* target, Motion& motion) {
  if (motion.grasps().samePlace(near->state, target)) return {near, true, false};
  const Motion::Reach reach = motion.extend(near->state, target, near->tree->grasp, near->tree->side);
  if (reach == Motion::Reach::kTrapped) return {nullptr, false, false, true};
  return {forests.grow(near, motion.end()), reach == Motion::Reach::kReached, true,
          reach == Motion::Reach::kStopped};
}

/// Extends the tree nearest to `target` on one side (FindNearestTree and ExpandTree). Nothing while the side
/// has no tree.
/// @tparam Forests  a ForestPair, or what has its grow() and nearest()
template <class Forests>
Expansion expand(Forests& forests, Side side, const ompl::base::State* target, Motion& motion) {
  const Node* near = forests.nearest(side, target);
  return near == nullptr ? Expansion{} : expandFrom(forests, near, target, motion);
}

/// What one iteration of RRT-Connect led to.
struct Growth {
  const Node* grown = nullptr;                           ///< where the side that grew has got to, if it moved
  std::optional<Junction> junction;                      ///< set when the two sides met
  std::size_t nodes = 0;                                 ///< how many were added
  double gap = std::numeric_limits<double>::infinity();  ///< from `grown` to where the other side has got
};

/// The second half of the iteration: `side` has got to `growth.grown`, and the other side grows straight
/// toward it.
/// @tparam Forests  see expand()
template <class Forests>
void connect(Forests& forests, Side side, Growth& growth, Motion& motion) {
  const ompl::base::State* target = growth.grown->state;
  const Node* near = forests.nearest(opposite(side), target);
  if (near == nullptr) return;
  Expansion met;
  do {
    met = expandFrom(forests, near, target, motion);
    growth.nodes += met.added;
    if (met.node != nullptr) near = met.node;
  } while (!met.reached && !met.blocked);
  growth.gap = motion.distance(near->state, target);
  if (met.reached)
    growth.junction = side == Side::kPick ? Junction{growth.grown, near} : Junction{near, growth.grown};
}

/// One iteration of RRT-Connect on forests whose trees share a grasp: `side` grows toward `target`, the other
/// side then grows toward the new node.
/// @tparam Forests  see expand()
template <class Forests>
Growth growAndConnect(Forests& forests, Side side, const ompl::base::State* target, Motion& motion) {
  Growth growth;
  const Expansion expansion = expand(forests, side, target, motion);
  growth.grown = expansion.node;
  growth.nodes = expansion.added;
  if (growth.grown != nullptr) connect(forests, side, growth, motion);
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
