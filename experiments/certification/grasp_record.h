// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "experiments/certification/planar/blocked_proof.h"
#include "robots/grasp.h"

namespace b4p {

enum class GraspStatus {
  kInvalidAtPick,  ///< no configuration found that holds the object at its start pose
  kNoPlacement,    ///< none found at any placement drawn, and no proof
  kCompatible,     ///< has a path, found and verified
  kBlocked,        ///< proved to have no path
  kUndecided,      ///< has roots at both ends; no path found, no proof
};

/// "invalid at pick", "no placement", "compatible", "blocked", "undecided".
std::string statusText(GraspStatus status);

/// What certification has found out about one grasp.
struct GraspRecord {
  int id = 0;
  Grasp grasp;
  GraspStatus status = GraspStatus::kInvalidAtPick;
  int placements_found = 0;       ///< of the placements drawn; 0 where the grasp is not valid at the pick
  planar::GridSize grid{0.0, 0};  ///< kBlocked: cells that the proof used
  double clearance_m = 0.0;       ///< kCompatible: smallest distance along its path
  std::uint64_t checks = 0;       ///< configurations looked at by the planner
  double seconds = 0.0;           ///< processor time spent on the grasp
  std::string failure;            ///< what the verifier found wrong with the path that was found; mostly ""
};

}  // namespace b4p
