// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace b4p {

/// Settings of B4P. Distances are in the metric of the state space, grasps left aside.
struct B4PParameters {
  unsigned threads = 1;  ///< parallel workers, 1 ... 64

  /// true: the algorithm as printed (Algorithms 1-4), with a fixed number of roots. false: the default
  /// search, see docs/b4p.md.
  bool paper = false;

  unsigned pick_roots =
      16;  ///< paper: N_pick, >= 1. Start states of the problem come first; all of them are used.
  unsigned place_roots = 16;  ///< paper: N_place, >= 1

  /// paper: > 0: drop all trees and draw new roots after so many iterations of all workers together; 0: never
  unsigned restart_iterations = 0;

  double range = 0.0;  ///< longest motion added at once; 0: as far as it stays free

  unsigned slice = 30;  ///< default: iterations a grasp's forests grow before another grasp's turn, >= 1
  unsigned retreat_steps =
      8;  ///< default: nodes in a row on each straight way out of a root; 0: no such ways
  unsigned root_attempts = 32;  ///< default: placements asked for (Eq. 3), or goal states of a problem
                                ///< without grasps, per turn of root drawing, >= 1
  unsigned repair_iterations =
      300;  ///< iterations of local replanning per colliding run before a repair fails, >= 1

  unsigned shortcuts = 100;  ///< default: shortcuts tried on the path found, as far as time allows; 0: none

  /// Ablations, in both modes. relaxed: trees of different grasps are joined, not only those of equal ones.
  /// repair: a path that collides after Eq. 3 is repaired, not thrown away.
  bool relaxed = true, repair = true;

  /// Ablation of the default search: where a motion is blocked, a tree goes on along one joint at a time, and
  /// nodes that cannot move are tried less often.
  bool slide = true;

  /// Empty when all is in range, otherwise what is not.
  std::string problem() const;
};

}  // namespace b4p
