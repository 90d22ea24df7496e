// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "experiments/scene.h"
#include "experiments/verification/convex_body.h"

namespace b4p::verification {

/// Clearance C of a placed object (Haustein et al., IROS 2019, section V) from its shapes and the obstacles',
/// without a grid of the surroundings: the mean, over cells of the object as large as the grid's, of the
/// distance to the nearest obstacle's point inside the target volume that is not lower. Distances are those
/// of convex solids; where the nearest point of one is too low or outside of the volume, the smallest part of
/// a ball around the point that touches it is found by halving.
class Clearance {
 public:
  /// @param scene  with a placement task; has to outlive this object
  explicit Clearance(const Scene& scene);

  /// C (m). Without any obstacle in the volume: the volume's diagonal.
  double mean_m(const Eigen::Isometry3d& X_WO) const;

  /// d_S of one point (m). A point outside the volume, or within half a cell of the placement grid
  /// from its border, counts as the nearest one farther inside.
  double at(const Eigen::Vector3d& p_W) const;

 private:
  bool touches(const PlacedBody& obstacle, const Eigen::Vector3d& p_W, double radius_m) const;
  bool counts(const Eigen::Vector3d& point_W, double lowest_m) const;

  const PlacementTask& task_;
  std::vector<PlacedBody> obstacles_;  ///< that reach into the volume
  std::vector<Eigen::Vector3d> points_O_;
  std::vector<Eigen::Vector3d> directions_;  ///< unit vectors spread over the upper half of a ball
};

}  // namespace b4p::verification
