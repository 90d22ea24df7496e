// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/problem.h"

namespace b4p {

/// A configuration (rad or m) that holds the object with a grasp at the start pose, or at a placement.
struct SolvedRoot {
  GraspId grasp = kNoGrasp;
  PlacementId placement = kNoPlacement;  ///< kNoPlacement: the start pose
  std::vector<double> q;
};

/// Placements of a scene and where the arm stands at its picks and placements.
struct SolvedRoots {
  std::vector<Eigen::Isometry3d> placements;  ///< X_WO
  std::vector<SolvedRoot> picks;              ///< at most one a grasp
  std::vector<SolvedRoot> places;             ///< at most one a pair, of grasps that have a pick
  int pairs_tried = 0;
};

/// Draws placements, and looks for the roots of all grasps of a problem at the start pose and at each
/// placement, placement by placement, until there are `most_places` of the latter. Depends on the seed alone.
/// @param problem  one that knows all its grasps (withGraspsOnly())
SolvedRoots solveRoots(const Problem& problem, int placements, int most_places, std::uint64_t seed);

/// The first of the roots that is wrong, by code that shares nothing with what found it: one line, or "".
/// Each has to lie inside the joint limits, hold the object where it says (within 0.1 mm and 1 mrad) and
/// touch nothing.
/// @throws InputError when the robot's files cannot be read
std::string rootsProblem(const Problem& problem, const SolvedRoots& roots);

}  // namespace b4p
