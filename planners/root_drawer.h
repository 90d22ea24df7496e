// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include <ompl/base/SpaceInformation.h>

#include "planners/pick_place_region.h"

namespace b4p {

/// One worker's draws from a pick-and-place region, as states of the problem's space. One per thread.
class RootDrawer {
 public:
  /// @param region  nullptr on a plain OMPL problem: nothing can be drawn then
  /// @param seed    determines the draws
  RootDrawer(const ompl::base::SpaceInformationPtr& si, const PickPlaceRegion* region, std::uint64_t seed);

  /// Draws a grasp and its pick root (Eq. 1) into root(). The grasp, or kNoGrasp when this draw gave nothing.
  GraspId drawPick();

  /// The same for an object that is to go to `placement`.
  GraspId drawPickFor(PlacementId placement);

  /// Eq. 3 into root(). False when there is no configuration.
  bool derivePlaceRoot(PlacementId placement, GraspId grasp);

  ompl::base::State* root() { return root_.get(); }
  PickPlaceContext& region() { return *region_; }

 private:
  std::unique_ptr<PickPlaceContext> region_;
  std::unique_ptr<ompl::base::State, std::function<void(ompl::base::State*)>> root_;
};

}  // namespace b4p
