// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "experiments/scene.h"
#include "experiments/verification/convex_body.h"

namespace b4p::verification {

/// What a placed object stands on, found with support functions and gaps between convex solids alone.
class Footing {
 public:
  /// @param scene  with a placement task; has to outlive this object
  explicit Footing(const Scene& scene);

  /// The points that an object at X_WO would stand on: corners of its shapes (rims of upright cylinders in 64
  /// points) in one plane with its lowest point, to 0.3 mm, that is tilted by 0.01 rad at most. A cylinder on
  /// its side has a foot at either end. In W.
  std::vector<Eigen::Vector3d> feet(const Eigen::Isometry3d& X_WO) const;

  /// How far below a point the first obstacle is (m), at most `farthest_m`; infinite beyond.
  double gap_m(const Eigen::Vector3d& p_W, double farthest_m) const;

  /// What keeps an object at X_WO from standing, one line; empty when nothing does: each foot has an obstacle
  /// below it within one and a half cells of the placement grid and 1 mm, all are inside the target volume,
  /// and the centre of mass stands above the polygon that they span, 8 mm inside it.
  /// @param largest_gap_m  the largest gap below a foot (m)
  std::string problem(const Eigen::Isometry3d& X_WO, double& largest_gap_m) const;

 private:
  const Scene& scene_;
  std::vector<PlacedBody> obstacles_;
};

}  // namespace b4p::verification
