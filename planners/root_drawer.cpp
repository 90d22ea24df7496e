// SPDX-License-Identifier: BSD-3-Clause
#include "planners/root_drawer.h"

#include "planners/manipulation_state_space.h"

namespace b4p {

namespace ob = ompl::base;

RootDrawer::RootDrawer(const ob::SpaceInformationPtr& si, const PickPlaceRegion* region, std::uint64_t seed)
    : region_(region != nullptr ? region->makeContext(seed) : nullptr),
      root_(si->allocState(), [si](ob::State* state) { si->freeState(state); }) {}

GraspId RootDrawer::drawPick() {
  auto* state = root()->as<ManipulationStateSpace::StateType>();
  return region().samplePick(state->q, state->grasp) ? state->grasp : kNoGrasp;
}

GraspId RootDrawer::drawPickFor(PlacementId placement) {
  auto* state = root()->as<ManipulationStateSpace::StateType>();
  return region().samplePickFor(placement, state->q, state->grasp) ? state->grasp : kNoGrasp;
}

bool RootDrawer::derivePlaceRoot(PlacementId placement, GraspId grasp) {
  auto* state = root()->as<ManipulationStateSpace::StateType>();
  state->grasp = grasp;
  return region().placeRoot(placement, grasp, state->q);
}

}  // namespace b4p
