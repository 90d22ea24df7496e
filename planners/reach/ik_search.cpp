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
  if (target_ == nullptr) {
    seekGoal();
    return {};
  }
  const std::optional<Junction> junction = grow();
  if (junction || --iterations_left_ == 0) dropGrasp();
  return junction;
}

void IkSearch::dropGrasp() {
  grasp_ = kNoGrasp;
  target_ = nullptr;
}

std::uint64_t IkSearch::inThisRound(unsigned budget) const {
  constexpr std::uint64_t kMostDoublings = 30;
  return static_cast<std::uint64_t>(budget) << std::min(deck_.roundsEnded(), kMostDoublings);
}

void IkSearch::seekGoal() {
  if (grasp_ == kNoGrasp) {
    grasp_ = deck_.next(configurations_.random());
    attempts_left_ = inThisRound(parameters_.ik_attempts);
    countOne(statistics().grasps_tried);
  }
  if (const ob::State* state = configurations_.attempt(grasp_)) {
    target_ = plantGoal(state, grasp_);
    iterations_left_ = inThisRound(parameters_.iterations);
    blocked_ = nullptr;
  } else if (--attempts_left_ == 0) {
    dropGrasp();
  }
}

std::optional<Junction> IkSearch::growToGoal() {
  const Node* near = forests().nearest(Side::kPick, target_->state);
  const Expansion grown = expand(forests(), Side::kPick, target_->state, motion());
  if (grown.added) countOne(statistics().nodes);
  if (grown.node == nullptr) blocked_ = near;
  if (!grown.reached) return {};
  return Junction{grown.node, target_};
}

// The first iteration tries the straight way to a new goal; later ones do not repeat a motion that failed.
std::optional<Junction> IkSearch::grow() {
  const bool first = iterations_left_ == inThisRound(parameters_.iterations);
  if (first || motion().random().uniform01() < parameters_.goal_bias)
    if (forests().nearest(Side::kPick, target_->state) != blocked_) return growToGoal();
  if (expand(forests(), Side::kPick, motion().sample(), motion()).added) countOne(statistics().nodes);
  return {};
}

}  // namespace b4p
