// SPDX-License-Identifier: BSD-3-Clause
#include "planners/reach/bik_search.h"

#include <utility>

namespace b4p {

namespace ob = ompl::base;

BikSearch::BikSearch(const ob::SpaceInformationPtr& si, const ReachGoal& goal,
                     const BIKRRTParameters& parameters, std::uint64_t seed, ReachStatistics& statistics)
    : ReachSearch(si, goal, GraspAccess(si).distance(), parameters.range, statistics),
      parameters_(parameters),
      configurations_(si, goal, seed, this->statistics()) {}

std::optional<Junction> BikSearch::step() {
  const bool without_goal = forests().treeCount(Side::kPlace) == 0;
  if (without_goal || motion().random().uniform01() < parameters_.ik_probability) {
    seekGoal();
    return {};
  }
  return grow();
}

void BikSearch::seekGoal() {
  const auto last = static_cast<GraspId>(goal().targets().size() - 1);
  const GraspId grasp = std::uniform_int_distribution<GraspId>(0, last)(configurations_.random());
  countOne(statistics().grasps_tried);
  for (unsigned i = 0; i < parameters_.ik_attempts; ++i) {
    if (const ob::State* state = configurations_.attempt(grasp)) {
      new_goal_ = plantGoal(state, grasp);
      return;
    }
  }
}

std::optional<Junction> BikSearch::grow() {
  const Node* new_goal = std::exchange(new_goal_, nullptr);
  const Side side = new_goal != nullptr ? Side::kPick : next_side_;
  const ob::State* target = new_goal != nullptr ? new_goal->state : motion().sample();
  const Growth growth = growAndConnect(forests(), side, target, motion());
  next_side_ = opposite(side);
  statistics().nodes += growth.nodes;
  return growth.junction;
}

}  // namespace b4p
