// SPDX-License-Identifier: BSD-3-Clause
#include "planners/reach/ik_search.h"

#include <algorithm>

namespace b4p {

namespace ob = ompl::base;

IkSearch::IkSearch(const ob::SpaceInformationPtr& si, const ReachGoal& goal,
                   const IKRRTParameters& parameters, std::uint64_t seed, ReachStatistics& statistics)
    : ReachSearch(si, goal, GraspAccess(si).distance(), parameters.range, statistics),
      parameters_(parameters),
      configurations_(si, goal, seed, this->statistics()),
      deck_(goal.targets().size()) {}

std::optional<Junction> IkSearch::step() {
  if (iterations_left_ == 0) {
    seekGoal();
    return {};
  }
  const std::optional<Junction> junction = grow();
  if (junction || --iterations_left_ == 0) dropGrasp();
  return junction;
}

void IkSearch::dropGrasp() {
  grasp_ = kNoGrasp;
  iterations_left_ = 0;
}

std::uint64_t IkSearch::inThisRound(unsigned budget) const { return budget * (deck_.roundsEnded() + 1); }

void IkSearch::seekGoal() {
  if (grasp_ == kNoGrasp) {
    grasp_ = deck_.next(configurations_.random());
    attempts_left_ = inThisRound(parameters_.ik_attempts);
    countOne(statistics().grasps_tried);
  }
  if (const ob::State* state = configurations_.attempt(grasp_)) {
    aimAt(plantGoal(state, grasp_));
    iterations_left_ = inThisRound(parameters_.iterations);
  } else if (--attempts_left_ == 0) {
    dropGrasp();
  }
}

void IkSearch::aimAt(const Node* goal_root) {
  const auto is_it = [goal_root](const Target& target) { return target.root == goal_root; };
  targets_.erase(std::remove_if(targets_.begin(), targets_.end(), is_it), targets_.end());
  targets_.push_back({goal_root, nullptr});
}

// A new goal is tried at once. Earlier ones keep half of the goal bias: the tree has grown since.
std::optional<Junction> IkSearch::grow() {
  Target& newest = targets_.back();
  if (iterations_left_ == inThisRound(parameters_.iterations)) return growTo(newest);
  if (motion().random().uniform01() >= parameters_.goal_bias) return growTo(motion().sample());
  if (motion().random().uniformBool()) return growTo(newest);
  return growTo(targets_[motion().random().uniformInt(0, static_cast<int>(targets_.size()) - 1)]);
}

// Does not repeat a motion that failed.
std::optional<Junction> IkSearch::growTo(Target& target) {
  const Node* near = forests().nearest(Side::kPick, target.root->state);
  if (near == target.blocked) return growTo(motion().sample());
  const std::optional<Junction> junction = growTo(target.root->state);
  if (!junction && forests().nearest(Side::kPick, target.root->state) == near) target.blocked = near;
  return junction;
}

// A node within the tolerance of any grasp is as good as the goal configuration aimed at.
std::optional<Junction> IkSearch::growTo(const ob::State* target) {
  const Expansion grown = expand(forests(), Side::kPick, target, motion());
  if (grown.node == nullptr) return {};
  if (grown.added) countOne(statistics().nodes);
  const GraspId grasp = goal().graspOf(grown.node->state);
  if (grasp == kNoGrasp) return {};
  return Junction{grown.node, plantGoal(grown.node->state, grasp)};
}

}  // namespace b4p
