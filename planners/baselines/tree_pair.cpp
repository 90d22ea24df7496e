// SPDX-License-Identifier: BSD-3-Clause
#include "planners/baselines/tree_pair.h"

namespace b4p {

namespace ob = ompl::base;

TreePair::TreePair(const ob::SpaceInformationPtr& si, const ob::State* pick, GraspId grasp,
                   Statistics& statistics)
    : statistics_(statistics), forests_(si, GraspAccess(si).distance(), grasp) {
  plant(Side::kPick, pick, grasp, kNoPlacement);
  countOne(statistics_.grasps_taken);
}

TreePair::~TreePair() { statistics_.nodes -= forests_.nodeCount(); }

Tree* TreePair::plant(Side side, const ob::State* root, GraspId grasp, PlacementId placement) {
  Tree* tree = forests_.plant(side, root, grasp, placement);
  trees_[index(side)] = tree;
  countOne(statistics_.roots);
  countOne(statistics_.nodes);
  return tree;
}

void TreePair::complete(const ob::State* place, PlacementId placement) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (complete()) return;
  plant(Side::kPlace, place, grasp(), placement);
  countOne(statistics_.pairs);
  complete_.store(true, std::memory_order_release);
}

std::optional<Junction> TreePair::grow(Side side, Motion& motion) {
  const bool first = iterations_.fetch_add(1, std::memory_order_relaxed) == 0;
  const ob::State* target = first ? trees_[index(opposite(side))]->root->state : motion.sample();
  const Growth growth = growAndConnect(forests_, side, target, motion);
  statistics_.nodes += growth.nodes;
  return growth.junction;
}

}  // namespace b4p
