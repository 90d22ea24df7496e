// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "experiments/scene.h"
#include "robots/grasp.h"

namespace b4p {

/// Draws grasps of an object. Immutable; any thread may call it with its own generator.
class GraspSampler {
 public:
  virtual ~GraspSampler() = default;

  /// All grasps there are, or empty when they form a continuum.
  virtual const std::vector<Grasp>& all() const = 0;

  /// One grasp; of a finite family each with equal probability.
  virtual Grasp sample(std::mt19937_64& random) const = 0;
};

/// A finite family: the grasps given.
class ListedGraspSampler : public GraspSampler {
 public:
  explicit ListedGraspSampler(std::vector<Grasp> grasps) : grasps_(std::move(grasps)) {}
  const std::vector<Grasp>& all() const override { return grasps_; }
  Grasp sample(std::mt19937_64& random) const override;

 private:
  std::vector<Grasp> grasps_;
};

/// Grasp i presses the gripper's front against the middle of edge i (corner i to corner i + 1) of a polygon
/// in the x-y plane of O, along the inward normal; the TCP stays `clearance_m` outside.
class PolygonEdgeGraspSampler : public ListedGraspSampler {
 public:
  PolygonEdgeGraspSampler(const std::vector<Eigen::Vector2d>& polygon_m, double clearance_m);
};

/// Parallel gripper on a box centred in O. The pads close on two opposite faces that fit between them. The
/// approach is perpendicular to the closing axis: half of the draws straight through one of the four other
/// faces, half at an angle about the closing axis that is uniform over the full turn. The TCP is uniform over
/// the part of the box's middle plane that lies at most `finger_depth_m` past the box's foremost point, so
/// the palm stays outside.
class BoxGraspSampler : public GraspSampler {
 public:
  /// @throws std::invalid_argument when no pair of faces fits `max_opening_m`, or a size is not positive.
  BoxGraspSampler(const Eigen::Vector3d& size_m, double finger_depth_m, double pad_clearance_m,
                  double max_opening_m);
  const std::vector<Grasp>& all() const override { return none_; }
  Grasp sample(std::mt19937_64& random) const override;

 private:
  Eigen::Vector3d half_;
  double finger_depth_m_;
  double pad_clearance_m_;
  std::vector<int> closing_axes_;
  std::vector<Grasp> none_;
};

/// Where a stick is and how it may be held, see StickGraspSampler.
struct StickGrasps {
  double length_m, radius_m;  ///< of the stick
  double margin_m;            ///< how far the TCP stays from its ends
  double finger_depth_m;      ///< how far the TCP reaches past the side it approaches from, <= 2 radius_m
  double pad_clearance_m;     ///< between the stick and each pad
};

/// Parallel gripper across a round stick along the z axis of O, its middle in O's origin. The pads close on
/// opposite sides; approach and closing axis are perpendicular to the stick. The approach is uniform over the
/// full turn around the stick, the position uniform along it.
class StickGraspSampler : public GraspSampler {
 public:
  /// @throws std::invalid_argument when the stick does not fit `max_opening_m` or leaves no room to hold it.
  StickGraspSampler(const StickGrasps& stick, double max_opening_m);
  const std::vector<Grasp>& all() const override { return none_; }
  Grasp sample(std::mt19937_64& random) const override;

 private:
  StickGrasps stick_;
  std::vector<Grasp> none_;
};

/// All grasps of a finite family; of others `count` draws, which depend on `seed` alone.
std::vector<Grasp> drawGrasps(const GraspSampler& sampler, int count, std::uint64_t seed);

std::unique_ptr<const GraspSampler> makeGraspSampler(const GraspSource& source, double max_opening_m);

}  // namespace b4p
