// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "experiments/samplers/surface.h"
#include "robots/grasp.h"
#include "robots/manipulator.h"

namespace b4p {

/// How a parallel gripper may hold an object.
struct AntipodalRules {
  /// At each contact the closing axis is at most this far off the surface's normal: the arc tangent of the
  /// friction coefficient.
  double friction_cone_rad = 15.0 * 3.14159265358979323846 / 180.0;
  /// Least gap between the object and each pad of the open gripper, along the closing axis (m).
  double pad_clearance_m = 0.005;
  /// The contacts lie this far behind the TCP, towards the palm (m); negative: beyond it.
  double contact_depth_m = 0.0;
  /// Least distance of the open hand from the object (m).
  double hand_clearance_m = 0.005;
};

/// Antipodal grasps of an object made of boxes, spheres, cylinders and capsules: a point of the surface,
/// uniform by area, a closing axis in its friction cone, uniform by solid angle, and the point where that
/// axis leaves the same piece. Approach: perpendicular to the closing axis, uniform about it. Immutable.
class AntipodalSampler {
 public:
  /// @param object  pieces in O; may overlap
  /// @throws std::invalid_argument for no pieces, a mesh, or rules out of range
  AntipodalSampler(const std::vector<PlacedShape>& object, double max_opening_m, const AntipodalRules& rules);

  /// One attempt. Nothing when the pair is no good: the far normal is outside the cone, the gripper does not
  /// open that far, or a contact lies inside another piece. The hand is not looked at.
  std::optional<Grasp> draw(std::mt19937_64& random) const;

 private:
  const Surface& drawPiece(std::mt19937_64& random) const;
  bool buried(const Eigen::Vector3d& p_O, const Surface& piece) const;

  std::vector<Surface> pieces_;
  double area_m2_ = 0.0;
  double max_opening_m_;
  AntipodalRules rules_;
};

/// Antipodal grasps at which the robot's open hand (the last moving link and all that hangs on it) stays
/// clear of the object, and its fingers do not reach into what the object stands on. Whether the rest of the
/// hand fits there is left open. Same seed, same grasps.
/// @param support  in O; may be empty
/// @throws std::invalid_argument as AntipodalSampler does, and when a million draws give fewer
std::vector<Grasp> antipodalGrasps(const std::shared_ptr<const Manipulator>& robot,
                                   const std::vector<PlacedShape>& object,
                                   const std::vector<PlacedShape>& support, const AntipodalRules& rules,
                                   std::size_t count, std::uint64_t seed);

}  // namespace b4p
