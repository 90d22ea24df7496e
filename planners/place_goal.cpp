// SPDX-License-Identifier: BSD-3-Clause
#include "planners/place_goal.h"

#include <limits>
#include <utility>

#include <ompl/base/SpaceInformation.h>

#include "planners/manipulation_state_space.h"

namespace b4p {

namespace ob = ompl::base;

using StateType = ManipulationStateSpace::StateType;

PlaceGoal::PlaceGoal(const ob::SpaceInformationPtr& si, std::shared_ptr<const PickPlaceRegion> region)
    : ob::GoalSampleableRegion(si), region_(std::move(region)) {
  setThreshold(std::numeric_limits<double>::epsilon());
  seed(0);
}

void PlaceGoal::seed(std::uint64_t seed) {
  std::lock_guard<std::mutex> lock(mutex_);
  context_ = region_->makeContext(seed);
  draws_ = 0;
}

void PlaceGoal::sampleGoal(ob::State* state) const {
  auto* s = state->as<StateType>();
  std::lock_guard<std::mutex> lock(mutex_);
  const GraspId grasps = region_->graspCount();
  s->grasp = grasps > 0 ? static_cast<GraspId>(draws_++ % static_cast<std::uint64_t>(grasps)) : kNoGrasp;
  if (s->grasp != kNoGrasp && context_->placeRoot(context_->samplePlacement(), s->grasp, s->q)) return;
  // A sample that every planner rejects: outside the bounds.
  const unsigned dof = si_->getStateSpace()->as<ManipulationStateSpace>()->dof();
  for (unsigned i = 0; i < dof; ++i) s->q[i] = std::numeric_limits<double>::infinity();
}

unsigned int PlaceGoal::maxSampleCount() const { return std::numeric_limits<unsigned int>::max(); }

double PlaceGoal::distanceGoal(const ob::State* state) const {
  const auto* s = state->as<StateType>();
  if (s->grasp == kNoGrasp || !si_->satisfiesBounds(state)) return std::numeric_limits<double>::infinity();
  return region_->distanceToPlacement(s->q, s->grasp);
}

bool PlaceGoal::isStartGoalPairValid(const ob::State* start, const ob::State* goal) const {
  return start->as<StateType>()->grasp == goal->as<StateType>()->grasp;
}

}  // namespace b4p
