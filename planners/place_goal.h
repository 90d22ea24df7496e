// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>

#include <ompl/base/goals/GoalSampleableRegion.h>

#include "planners/pick_place_region.h"

namespace b4p {

/// "The object lies in its placement region": a goal over a ManipulationStateSpace for any OMPL planner.
/// B4P recognises it and takes pick roots, placements and re-derived place roots (Eq. 3) from region()
/// itself.
///
/// sampleGoal() draws a placement for each known grasp in turn, so that the problem's start states, which
/// carry the grasps, come first. Where no configuration is found the sample is outside the bounds and
/// planners reject it. Never throws; any thread may call it. isStartGoalPairValid() holds for states of equal
/// grasp.
class PlaceGoal : public ompl::base::GoalSampleableRegion {
 public:
  PlaceGoal(const ompl::base::SpaceInformationPtr& si, std::shared_ptr<const PickPlaceRegion> region);

  const PickPlaceRegion& region() const { return *region_; }

  /// Restarts the stream that sampleGoal() draws from.
  void seed(std::uint64_t seed);

  void sampleGoal(ompl::base::State* state) const override;
  unsigned int maxSampleCount() const override;
  double distanceGoal(const ompl::base::State* state) const override;
  bool isStartGoalPairValid(const ompl::base::State* start, const ompl::base::State* goal) const override;

 private:
  std::shared_ptr<const PickPlaceRegion> region_;
  mutable std::mutex mutex_;
  mutable std::unique_ptr<PickPlaceContext> context_;
  mutable std::uint64_t draws_ = 0;
};

}  // namespace b4p
