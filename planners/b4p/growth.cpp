// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/growth.h"

#include <algorithm>
#include <vector>

namespace b4p {

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

Expansion expandFrom(ForestPair& forests, const Node* near, const ob::State* target, Motion& motion) {
  if (motion.grasps().samePlace(near->state, target)) return {near, true, false};
  const Motion::Reach reach = motion.extend(near->state, target, near->tree->grasp, near->tree->side);
  if (reach == Motion::Reach::kTrapped) return {};
  return {forests.grow(near, motion.end()), reach == Motion::Reach::kReached, true};
}

}  // namespace

Expansion expand(ForestPair& forests, Side side, const ob::State* target, Motion& motion) {
  const Node* near = forests.nearest(side, target);
  return near == nullptr ? Expansion{} : expandFrom(forests, near, target, motion);
}

Growth growAndConnect(ForestPair& forests, Side side, const ob::State* target, Motion& motion) {
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

JoinedPath pathThrough(const Junction& junction, const ob::SpaceInformationPtr& si) {
  const GraspAccess grasps(si);
  const GraspId grasp = junction.pick->tree->grasp;
  std::vector<const Node*> nodes;
  for (const Node* node = junction.pick; node != nullptr; node = node->parent) nodes.push_back(node);
  std::reverse(nodes.begin(), nodes.end());
  const std::size_t picks = nodes.size();
  for (const Node* node = junction.place; node != nullptr; node = node->parent) nodes.push_back(node);

  JoinedPath joined{og::PathGeometric(si), 0};
  og::PathGeometric& path = joined.path;
  ob::State* state = si->allocState();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    si->copyState(state, nodes[i]->state);
    grasps.set(state, grasp);
    if (path.getStateCount() == 0 || !si->equalStates(path.getStates().back(), state)) path.append(state);
    if (i < picks) joined.junction = path.getStateCount() - 1;
  }
  // `state` is the place root: the path ends in it exactly, not in a state that merely counts as equal.
  if (path.getStateCount() == 1)
    path.append(state);
  else
    si->copyState(path.getStates().back(), state);
  si->freeState(state);
  return joined;
}

}  // namespace b4p
