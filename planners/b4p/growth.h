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

/// Extends the tree nearest to `target` on one side as far as the motion stays free (Algorithm 3,
/// FindNearestTree and ExpandTree). Nothing while the side has no tree.
Expansion expand(ForestPair& forests, Side side, const ompl::base::State* target, Motion& motion);

/// What one iteration of growAndConnect() led to.
struct Growth {
  const Node* grown = nullptr;       ///< where the side that grew has got to, if it moved
  std::optional<Junction> junction;  ///< set when the two sides met
  std::size_t nodes = 0;             ///< how many were added
};

/// One iteration of RRT-Connect on forests whose trees share a grasp: `side` grows toward `target`, the other
/// side then grows toward the new node.
Growth growAndConnect(ForestPair& forests, Side side, const ompl::base::State* target, Motion& motion);

/// A path from a pick root over a junction to a place root.
struct JoinedPath {
  ompl::geometric::PathGeometric path;
  std::size_t junction;  ///< index of the junction's pick node: up to it all motions are known to be free
};

/// The path has both roots, all states set to the grasp of the pick tree; a state that repeats is left out.
JoinedPath pathThrough(const Junction& junction, const ompl::base::SpaceInformationPtr& si);

}  // namespace b4p
