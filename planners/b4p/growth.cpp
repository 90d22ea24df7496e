// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/growth.h"

#include <algorithm>
#include <vector>

namespace b4p {

namespace ob = ompl::base;
namespace og = ompl::geometric;

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
