// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>

#include "planners/b4p/growth.h"
#include "planners/b4p/motion.h"
#include "planners/b4p/search.h"

namespace b4p {

/// Does a query's work one step at a time: a step is one iteration of growth, one iteration of local
/// replanning, or one drawing of a root. Workers share a Search; each is used by one thread at a time, which
/// need not be always the same. A step takes as long as a few edge checks or inverse-kinematics calls.
class Worker {
 public:
  /// @param seed  of this worker's draws from the pick-and-place region; the state sampler has OMPL's
  Worker(Search& search, std::uint64_t seed);
  virtual ~Worker() = default;
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// One step. Does nothing once the search has finished. May throw what the problem's own functions throw.
  void step();

  /// Lets others go on with what this worker has begun: it will not be stepped for a while.
  virtual void rest() {}

 protected:
  /// One step of the search itself, when there is no repair to help with.
  virtual void advance() = 0;

  /// What becomes of a repair that failed.
  virtual void salvage(const PathRepair& repair) = 0;

  /// What becomes of a connection whose path collides, where paths are not repaired.
  virtual void discard(const Junction& junction) = 0;

  /// A grasp drawn, or kNoGrasp, and whether its pick root is a new one.
  struct Pick {
    GraspId grasp = kNoGrasp;
    bool is_new = false;
  };

  /// Draws a grasp and plants its pick root, unless it is there already.
  Pick drawPick();

  /// Eq. 3 into root(). False when there is no configuration.
  bool derivePlaceRoot(PlacementId placement, GraspId grasp);

  /// Submits the path over a junction of different grasps, its last state replaced by `place_root`, for
  /// repair (Algorithm 1, lines 5 and 6). Without repair it is published if it is free, and otherwise
  /// discarded.
  void repair(const Junction& junction, const ompl::base::State* place_root);

  Search& search() { return search_; }
  Motion& motion() { return motion_; }
  PickPlaceContext& region() { return *region_; }
  ompl::base::State* root() { return root_.get(); }

 private:
  void helpRepair(const std::shared_ptr<PathRepair>& repair);
  void endRepair(const std::shared_ptr<PathRepair>& repair);

  Search& search_;
  Motion motion_;
  std::unique_ptr<PickPlaceContext> region_;
  std::unique_ptr<ompl::base::State, std::function<void(ompl::base::State*)>> root_;
};

/// The worker that the search's parameters ask for.
std::unique_ptr<Worker> makeWorker(Search& search, std::uint64_t seed);

}  // namespace b4p
