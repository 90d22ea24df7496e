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

/// Extends the tree nearest to `target` on one side as far as the motion stays free (Algorithm 3,
/// FindNearestTree and ExpandTree).
/// @return the node reached, nullptr when it could not move or there is no tree
const Node* expand(ForestPair& forests, Side side, const ompl::base::State* target, Motion& motion);

/// What one iteration of growAndConnect() led to.
struct Growth {
  const Node* grown = nullptr;       ///< the node added on the side that grew, if any
  std::optional<Junction> junction;  ///< set when the two sides met
  std::size_t nodes = 0;             ///< how many were added
};

/// One iteration of RRT-Connect on forests whose trees share a grasp: `side` grows toward `target`, the other
/// side then grows toward the new node.
Growth growAndConnect(ForestPair& forests, Side side, const ompl::base::State* target, Motion& motion);

/// States from the pick root over the junction to the place root, at least these two, all set to the grasp of
/// the pick tree; a state that repeats is left out.
ompl::geometric::PathGeometric pathThrough(const Junction& junction,
                                           const ompl::base::SpaceInformationPtr& si);

/// Number of nodes from the node's root to the node.
std::size_t depth(const Node* node);

}  // namespace b4p
