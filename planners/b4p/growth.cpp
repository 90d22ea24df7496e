// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/growth.h"

#include <algorithm>
#include <vector>

namespace b4p {

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

/// The node at the end of a motion from `near` toward `target`, and whether it is the target.
struct Expansion {
  const Node* node = nullptr;
  bool reached = false;
};

Expansion expandFrom(ForestPair& forests, const Node* near, const ob::State* target, Motion& motion) {
  const Motion::Reach reach = motion.extend(near->state, target, near->tree->grasp, near->tree->side);
  if (reach == Motion::Reach::kTrapped) return {};
  return {forests.grow(near, motion.end()), reach == Motion::Reach::kReached};
}

}  // namespace

const Node* expand(ForestPair& forests, Side side, const ob::State* target, Motion& motion) {
  const Node* near = forests.nearest(side, target);
  return near == nullptr ? nullptr : expandFrom(forests, near, target, motion).node;
}

Growth growAndConnect(ForestPair& forests, Side side, const ob::State* target, Motion& motion) {
  Growth growth;
  growth.grown = expand(forests, side, target, motion);
  if (growth.grown == nullptr) return growth;
  growth.nodes = 1;
  const Node* facing = forests.nearest(opposite(side), growth.grown->state);
  if (facing == nullptr) return growth;
  Expansion met = expandFrom(forests, facing, growth.grown->state, motion);
  while (met.node != nullptr) {
    ++growth.nodes;
    if (met.reached) break;
    const Node* from = met.node;
    met = expandFrom(forests, from, growth.grown->state, motion);
  }
  if (met.reached)
    growth.junction =
        side == Side::kPick ? Junction{growth.grown, met.node} : Junction{met.node, growth.grown};
  return growth;
}

og::PathGeometric pathThrough(const Junction& junction, const ob::SpaceInformationPtr& si) {
  const GraspAccess grasps(si);
  const GraspId grasp = junction.pick->tree->grasp;
  std::vector<const Node*> nodes;
  for (const Node* node = junction.pick; node != nullptr; node = node->parent) nodes.push_back(node);
  std::reverse(nodes.begin(), nodes.end());
  for (const Node* node = junction.place; node != nullptr; node = node->parent) nodes.push_back(node);

  og::PathGeometric path(si);
  ob::State* state = si->allocState();
  for (const Node* node : nodes) {
    si->copyState(state, node->state);
    grasps.set(state, grasp);
    if (path.getStateCount() == 0 || !si->equalStates(path.getStates().back(), state)) path.append(state);
  }
  // `state` is the place root: the path ends in it exactly, not in a state that merely counts as equal.
  if (path.getStateCount() == 1)
    path.append(state);
  else
    si->copyState(path.getStates().back(), state);
  si->freeState(state);
  return path;
}

std::size_t depth(const Node* node) {
  std::size_t count = 0;
  for (; node != nullptr; node = node->parent) ++count;
  return count;
}

}  // namespace b4p
