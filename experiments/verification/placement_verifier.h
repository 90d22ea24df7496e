// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "experiments/placement/placement_improvement.h"
#include "experiments/scene.h"

namespace b4p {

/// Re-checks motions to placements with code of its own, as verify() does for picking and placing:
/// - joints are the arm's, in order, and inside their limits; the first way-point is the arm's start;
/// - along every edge nothing touches, at a tenth of the scene's step (see verify()); the other arms stand at
///   their starts, empty-handed;
/// - the pose at the end is the one stated, the object stands on obstacles with all its feet inside the
/// target
///   volume and its centre of mass above them (verification::Footing);
/// - the objective recomputed from the shapes differs from the one stated by no more than one and a half
/// cells
///   of the placement grid (verification::Clearance).
/// For one thread.
class PlacementVerifier {
 public:
  /// @param scene  with a placement task; has to outlive this object
  /// @param sign   of the clearance in the objective: 1 or -1
  PlacementVerifier(const Scene& scene, double sign);
  ~PlacementVerifier();

  /// @throws InputError when the arm's URDF cannot be read or lacks what its robot file names
  PlacementVerification verify(const PlacementImprovement& improvement,
                               const std::vector<std::string>& joint_names) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace b4p
