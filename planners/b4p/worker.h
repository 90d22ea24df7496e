// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>

#include "planners/b4p/growth.h"
#include "planners/b4p/motion.h"
#include "planners/b4p/search.h"
#include "planners/root_drawer.h"

namespace b4p {

/// A worker of B4P: a step is one iteration of growth, one iteration of local replanning, or one drawing of a
/// root.
class Worker : public ParallelWorker {
 public:
  /// @param seed  of this worker's draws from the pick-and-place region; the state sampler has OMPL's
  Worker(Search& search, std::uint64_t seed);

  void step() override;

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
  Pick drawPick() { return plantPick(drawer_.drawPick()); }

  /// The same for an object that is to go to `placement`.
  Pick drawPickFor(PlacementId placement) { return plantPick(drawer_.drawPickFor(placement)); }

  /// Eq. 3 into root(). False when there is no configuration.
  bool derivePlaceRoot(PlacementId placement, GraspId grasp) {
    return drawer_.derivePlaceRoot(placement, grasp);
  }

  /// Submits the path over a junction of different grasps, its last state replaced by `place_root`, for
  /// repair (Algorithm 1, lines 5 and 6). Without repair it is published if it is free, and otherwise
  /// discarded.
  void repair(const Junction& junction, const ompl::base::State* place_root);

  Search& search() { return search_; }
  Motion& motion() { return motion_; }
  PickPlaceContext& region() { return drawer_.region(); }
  ompl::base::State* root() { return drawer_.root(); }

 private:
  /// Whether another pick root of a grasp may join.
  virtual bool wantsPick(GraspId grasp) {
    static_cast<void>(grasp);
    return true;
  }
  Pick plantPick(GraspId grasp);
  void helpRepair(const std::shared_ptr<PathRepair>& repair);
  void endRepair(const std::shared_ptr<PathRepair>& repair);

  Search& search_;
  Motion motion_;
  RootDrawer drawer_;
};

/// The worker that the search's parameters ask for.
std::unique_ptr<Worker> makeWorker(Search& search, std::uint64_t seed);

}  // namespace b4p
