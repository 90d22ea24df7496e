// SPDX-License-Identifier: BSD-3-Clause
#include "planners/reach/ik_search.h"

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

std::uint64_t IkSearch::inThisRound(unsigned budget) const { return budget * (deck_.roundsEnded() + 1); }

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
  if (grown.node == nullptr) blocked_ = near;
  if (grown.reached) {
    statistics().nodes += grown.added;
    return Junction{grown.node, target_};
  }
  return grown.added ? accepted(grown.node) : std::nullopt;
}

// A node that happens to be within the tolerance of some grasp is as good as the one aimed at.
std::optional<Junction> IkSearch::accepted(const Node* node) {
  countOne(statistics().nodes);
  const GraspId grasp = goal().graspOf(node->state);
  if (grasp == kNoGrasp) return {};
  return Junction{node, plantGoal(node->state, grasp)};
}

// The first iteration tries the straight way to a new goal; later ones do not repeat a motion that failed.
std::optional<Junction> IkSearch::grow() {
  const bool first = iterations_left_ == inThisRound(parameters_.iterations);
  if (first || motion().random().uniform01() < parameters_.goal_bias)
    if (forests().nearest(Side::kPick, target_->state) != blocked_) return growToGoal();
  const Expansion grown = expand(forests(), Side::kPick, motion().sample(), motion());
  return grown.added ? accepted(grown.node) : std::nullopt;
}

}  // namespace b4p
