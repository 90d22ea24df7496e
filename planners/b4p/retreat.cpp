// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/retreat.h"

#include <algorithm>
#include <vector>

#include "planners/manipulation_state_space.h"

namespace b4p {

namespace ob = ompl::base;

namespace {

double* joints(ob::State* state) { return state->as<ManipulationStateSpace::StateType>()->q; }
const double* joints(const ob::State* state) { return state->as<ManipulationStateSpace::StateType>()->q; }

}  // namespace

std::size_t retreat(Tree& tree, unsigned steps, PickPlaceContext& region, Motion& motion,
                    ob::State* scratch) {
  if (steps == 0 || tree.has_retreated.exchange(true)) return 0;
  std::size_t added = 0;
  unsigned longest = 0;
  std::vector<int> reach(static_cast<std::size_t>(region.retreatDirections()));
  region.retreatReach(joints(tree.root->state), tree.grasp, static_cast<int>(steps), reach.data());
  for (int direction = 0; direction < region.retreatDirections(); ++direction) {
    const Node* node = tree.root;
    const auto most = static_cast<unsigned>(reach[static_cast<std::size_t>(direction)]);
    for (unsigned step = 0; step < most; ++step) {
      if (!region.retreat(joints(node->state), tree.grasp, direction, joints(scratch))) break;
      motion.grasps().set(scratch, tree.grasp);
      if (motion.extend(node->state, scratch, tree.grasp, tree.side) != Motion::Reach::kReached) break;
      node = tree.home->grow(node, motion.end());
      ++added;
      longest = std::max(longest, step + 1);
    }
  }
  tree.way_out = longest;
  return added;
}

}  // namespace b4p
