// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>

namespace b4p {

/// Numbers a grasp. Two states carry the object alike exactly when their ids are equal.
using GraspId = std::int32_t;
/// Numbers an object placement x_place drawn from the placement region.
using PlacementId = std::int32_t;

constexpr GraspId kNoGrasp = -1;
constexpr PlacementId kNoPlacement = -1;

/// One thread's access to a PickPlaceRegion. q arrays hold one value per joint.
class PickPlaceContext {
 public:
  virtual ~PickPlaceContext() = default;

  /// PLANPICK (paper, Eq. 1): one draw. True: `q` holds the object at its start pose with `grasp` and is
  /// valid. False: this draw gave nothing, another may.
  virtual bool samplePick(double* q, GraspId& grasp) = 0;

  /// samplePick() for an object that is then to go to `placement`: may pass over grasps that cannot hold it
  /// there before anything dear is tried.
  virtual bool samplePickFor(PlacementId placement, double* q, GraspId& grasp) {
    static_cast<void>(placement);
    return samplePick(q, grasp);
  }

  /// PLANPLACE (Eq. 2): draws an object pose inside the region.
  virtual PlacementId samplePlacement() = 0;

  /// Eq. 3: a valid configuration that holds the object at `placement` with `grasp`. False when none was
  /// found.
  virtual bool placeRoot(PlacementId placement, GraspId grasp, double* q) = 0;

  /// Ways straight out of a narrow place, along which trees may leave their roots: how many directions there
  /// are. 0 where a region knows none.
  virtual int retreatDirections() const { return 0; }

  /// How many of `steps` steps from q on are worth trying in each direction: `reach` gets retreatDirections()
  /// values. All of them where a region knows nothing cheaper than to try.
  virtual void retreatReach(const double* q, GraspId grasp, int steps, int* reach) {
    static_cast<void>(q), static_cast<void>(grasp);
    std::fill_n(reach, retreatDirections(), steps);
  }

  /// The configuration a little further along direction 0 ... retreatDirections()-1, the object keeping its
  /// orientation, near q. Not checked for collisions. False when there is none.
  virtual bool retreat(const double* q, GraspId grasp, int direction, double* next) {
    static_cast<void>(q), static_cast<void>(grasp), static_cast<void>(direction), static_cast<void>(next);
    return false;
  }
};

/// Where the object is picked and where it may be placed. Immutable but for its tables of grasps and
/// placements, which only grow; all functions may be called from any thread. Nothing here throws once
/// constructed, but for std::bad_alloc.
class PickPlaceRegion {
 public:
  virtual ~PickPlaceRegion() = default;

  /// A context whose draws depend on `seed` alone.
  virtual std::unique_ptr<PickPlaceContext> makeContext(std::uint64_t seed) const = 0;

  /// Ids 0 ... graspCount()-1 are known.
  virtual GraspId graspCount() const = 0;

  /// How far (m, plus radians of tilt where the region asks for an orientation) the object held with `grasp`
  /// at q is from being placed; 0 inside the region.
  virtual double distanceToPlacement(const double* q, GraspId grasp) const = 0;
};

}  // namespace b4p
