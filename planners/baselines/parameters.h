// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace b4p {

/// Settings that all baselines have. Distances are in the metric of the state space, grasps left aside.
struct BaselineParameters {
  unsigned threads = 1;  ///< parallel workers, 1 ... 64
  double range = 0.0;    ///< longest motion added at once; 0: as far as it stays free

  /// How many placements without a place root (Eq. 3) make a grasp be given up, >= 1.
  unsigned placement_attempts = 32;

  /// Empty when all is in range, otherwise what is not.
  std::string problem() const;
};

/// Settings of the baselines that keep to a grasp once it is drawn, as the paper has them.
struct KeepingParameters : BaselineParameters {
  /// false: a grasp without a place root is kept, and further placements are tried for it (literal). true:
  /// after `placement_attempts` failed placements another grasp is drawn.
  bool redraw = false;
};

/// Settings of RRTIndividual.
using RRTIndividualParameters = KeepingParameters;

/// Settings of RRTShared.
struct RRTSharedParameters : KeepingParameters {
  double restart_s = 10.0;  ///< time until the trees are dropped for another grasp, > 0 s

  /// > 0: restarts after so many steps of all workers together instead, so that one seed gives one result.
  unsigned restart_iterations = 0;

  std::string problem() const;
};

/// Settings of RRTRestart.
struct RRTRestartParameters : BaselineParameters {
  RRTRestartParameters() { placement_attempts = 4; }

  unsigned slice = 1000;        ///< iterations of a pair's first slice, >= 1
  double growth = 2.0;          ///< each slice is so many times the one before, 1 ... 10
  unsigned root_attempts = 32;  ///< roots drawn per `slice` iterations of growth, >= 1

  std::string problem() const;
};

}  // namespace b4p
