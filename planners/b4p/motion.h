// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateSampler.h>
#include <ompl/util/RandomNumbers.h>

#include "planners/b4p/forest.h"

namespace b4p {

/// Whether the states of a space carry grasps, and how far apart they are for B4P: by their joints alone.
class GraspAccess {
 public:
  explicit GraspAccess(const ompl::base::SpaceInformationPtr& si);
  bool present() const { return present_; }
  GraspId get(const ompl::base::State* state) const;        ///< kNoGrasp where states carry none
  void set(ompl::base::State* state, GraspId grasp) const;  ///< nothing where states carry none
  StateDistance distance() const;
  /// True when two states differ in nothing but, perhaps, the grasp.
  bool samePlace(const ompl::base::State* a, const ompl::base::State* b) const;

 private:
  ompl::base::SpaceInformationPtr si_;
  bool present_;
};

/// One worker's hands in the state space: samples, and straight motions under a chosen grasp. Works on any
/// SpaceInformation. One per thread.
class Motion {
 public:
  /// How far a motion got.
  enum class Reach {
    kTrapped,   ///< nowhere: it is blocked at once
    kStopped,   ///< as far as it is free
    kAdvanced,  ///< the whole of its range
    kReached    ///< to its target
  };

  Motion(const ompl::base::SpaceInformationPtr& si, double range);
  ~Motion();
  Motion(const Motion&) = delete;
  Motion& operator=(const Motion&) = delete;

  /// A random state, good until the next sample.
  const ompl::base::State* sample();

  /// A random state, half the time near the straight motion from a to b and otherwise anywhere.
  const ompl::base::State* sampleAround(const ompl::base::State* a, const ompl::base::State* b);

  /// Goes from `from` toward `to` under `grasp` as far as the motion stays free, at most `range`. Where it
  /// ends is end(). On the place side the motion is the one that leads back to `from`; where spaces tell the
  /// two directions apart, it is free as a whole or not made.
  Reach extend(const ompl::base::State* from, const ompl::base::State* to, GraspId grasp, Side side);
  const ompl::base::State* end() const { return end_; }

  /// Grasps left aside.
  double distance(const ompl::base::State* a, const ompl::base::State* b) const { return distance_(a, b); }

  /// How many values of a state can be moved one at a time: joints, coordinates of R^n, angles. 0 in spaces
  /// with other values, and in those whose motions are not straight.
  unsigned values() const { return values_; }

  /// `from` with one of its values moved to that of `to`, good until the next call; nullptr when it is there.
  const ompl::base::State* alongValue(unsigned value, const ompl::base::State* from,
                                      const ompl::base::State* to);

  /// True when the straight motion a -> b is free under `grasp`.
  bool isFree(const ompl::base::State* a, const ompl::base::State* b, GraspId grasp);

  const GraspAccess& grasps() const { return grasps_; }
  ompl::RNG& random() { return random_; }

 private:
  ompl::base::SpaceInformationPtr si_;
  GraspAccess grasps_;
  StateDistance distance_;
  double range_;
  bool symmetric_;  ///< whether motions a -> b and b -> a are the same points
  unsigned values_;
  ompl::base::StateSamplerPtr sampler_;
  ompl::RNG random_;
  ompl::base::State *sample_, *from_, *to_, *end_, *beside_;
};

}  // namespace b4p
