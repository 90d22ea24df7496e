// SPDX-License-Identifier: BSD-3-Clause
#include "planners/reach/reach_search.h"

namespace b4p {

namespace ob = ompl::base;

ReachSearch::ReachSearch(const ob::SpaceInformationPtr& si, const ReachGoal& goal,
                         const StateDistance& distance, double range, ReachStatistics& statistics)
    : si_(si), goal_(goal), forests_(si, distance, kNoGrasp), motion_(si, range), statistics_(statistics) {}

bool ReachSearch::plantStart(const ob::State* start) {
  const Tree* tree = forests_.plant(Side::kPick, start, kNoGrasp, kNoPlacement);
  if (tree == nullptr) return false;
  countOne(statistics_.nodes);
  const GraspId grasp = goal_.graspOf(start);
  if (grasp != kNoGrasp) start_in_goal_ = Junction{tree->root, plantGoal(start, grasp)};
  startPlanted(tree->root);
  return true;
}

std::optional<Junction> ReachSearch::startInGoal() {
  std::optional<Junction> junction;
  std::swap(junction, start_in_goal_);
  return junction;
}

const Node* ReachSearch::plantGoal(const ob::State* state, GraspId grasp) {
  const Tree* tree = forests_.plant(Side::kPlace, state, kNoGrasp, grasp);
  if (tree == nullptr) {
    for (const Tree* present : forests_.trees(Side::kPlace))
      if (si_->equalStates(present->root->state, state)) return present->root;
  }
  countOne(statistics_.nodes);
  countOne(statistics_.goal_roots);
  return tree->root;
}

}  // namespace b4p
