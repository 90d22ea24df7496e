// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/samplers/grasp_sampler.h"

#include <cmath>
#include <stdexcept>

namespace b4p {
namespace {

constexpr double kPi = 3.14159265358979323846;

double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

int uniformIndex(std::mt19937_64& random, std::size_t count) {
  return std::uniform_int_distribution<int>(0, static_cast<int>(count) - 1)(random);
}

/// Frame with the given z (approach) and y (closing) axes.
Eigen::Matrix3d toolAxes(const Eigen::Vector3d& approach, const Eigen::Vector3d& closing) {
  Eigen::Matrix3d axes;
  axes << closing.cross(approach), closing, approach;
  return axes;
}

std::vector<Grasp> edgeGrasps(const std::vector<Eigen::Vector2d>& polygon_m, double clearance_m) {
  std::vector<Grasp> grasps;
  for (std::size_t i = 0; i < polygon_m.size(); ++i) {
    const Eigen::Vector2d& a = polygon_m[i];
    const Eigen::Vector2d& b = polygon_m[(i + 1) % polygon_m.size()];
    const Eigen::Vector2d along = (b - a).normalized();
    const Eigen::Vector3d inward(-along.y(), along.x(), 0.0);  // the outline runs counter-clockwise
    Grasp grasp;
    grasp.X_OT.linear() = toolAxes(inward, Eigen::Vector3d::UnitZ().cross(inward));
    const Eigen::Vector2d middle = (a + b) / 2.0;
    grasp.X_OT.translation() = Eigen::Vector3d(middle.x(), middle.y(), 0.0) - clearance_m * inward;
    grasps.push_back(grasp);
  }
  return grasps;
}

}  // namespace

Grasp ListedGraspSampler::sample(std::mt19937_64& random) const {
  return grasps_[static_cast<std::size_t>(uniformIndex(random, grasps_.size()))];
}

PolygonEdgeGraspSampler::PolygonEdgeGraspSampler(const std::vector<Eigen::Vector2d>& polygon_m,
                                                 double clearance_m)
    : ListedGraspSampler(edgeGrasps(polygon_m, clearance_m)) {}

BoxGraspSampler::BoxGraspSampler(const Eigen::Vector3d& size_m, double finger_depth_m, double pad_clearance_m,
                                 double max_opening_m)
    : half_(size_m / 2.0), finger_depth_m_(finger_depth_m), pad_clearance_m_(pad_clearance_m) {
  if (!(size_m.minCoeff() > 0.0) || !(finger_depth_m > 0.0) || !(pad_clearance_m >= 0.0))
    throw std::invalid_argument("sizes and finger depth of a box grasp have to be positive");
  for (int axis = 0; axis < 3; ++axis)
    if (size_m[axis] + 2.0 * pad_clearance_m <= max_opening_m) closing_axes_.push_back(axis);
  if (closing_axes_.empty()) throw std::invalid_argument("no pair of faces of the box fits the gripper");
}

Grasp BoxGraspSampler::sample(std::mt19937_64& random) const {
  constexpr int kDrawsPerAngle = 1000;
  constexpr int kSides = 4;
  const int closing = closing_axes_[static_cast<std::size_t>(uniformIndex(random, closing_axes_.size()))];
  const int u = (closing + 1) % 3, v = (closing + 2) % 3;
  const Eigen::Vector3d closing_axis =
      (uniformIndex(random, 2) == 0 ? 1.0 : -1.0) * Eigen::Vector3d::Unit(closing);
  for (;;) {
    Eigen::Vector3d approach = Eigen::Vector3d::Zero();
    if (uniformIndex(random, 2) == 0) {
      const int side = uniformIndex(random, kSides);
      approach[side / 2 == 0 ? u : v] = side % 2 == 0 ? 1.0 : -1.0;
    } else {
      const double angle = uniform(random, 0.0, 2.0 * kPi);
      approach[u] = std::cos(angle);
      approach[v] = std::sin(angle);
    }
    // Extent of the box against the approach direction: where the box's foremost point lies.
    const double foremost = half_.dot(approach.cwiseAbs());
    for (int draw = 0; draw < kDrawsPerAngle; ++draw) {
      Eigen::Vector3d p_OT = Eigen::Vector3d::Zero();
      p_OT[u] = uniform(random, -half_[u], half_[u]);
      p_OT[v] = uniform(random, -half_[v], half_[v]);
      if (p_OT.dot(approach) + foremost > finger_depth_m_) continue;
      Grasp grasp;
      grasp.X_OT.linear() = toolAxes(approach, closing_axis);
      grasp.X_OT.translation() = p_OT;
      grasp.opening_m = 2.0 * (half_[closing] + pad_clearance_m_);
      return grasp;
    }
  }
}

StickGraspSampler::StickGraspSampler(const StickGrasps& stick, double max_opening_m) : stick_(stick) {
  if (!(stick.radius_m > 0.0) || !(stick.margin_m >= 0.0) || !(2.0 * stick.margin_m <= stick.length_m))
    throw std::invalid_argument("radius and margins of a stick grasp leave nothing to hold");
  if (!(stick.finger_depth_m > 0.0) || !(stick.finger_depth_m <= 2.0 * stick.radius_m))
    throw std::invalid_argument("fingers have to reach into the stick's thickness");
  if (!(stick.pad_clearance_m >= 0.0) || !(2.0 * (stick.radius_m + stick.pad_clearance_m) <= max_opening_m))
    throw std::invalid_argument("the stick does not fit the gripper");
}

Grasp StickGraspSampler::sample(std::mt19937_64& random) const {
  const double reach_m = stick_.length_m / 2.0 - stick_.margin_m;
  const double along_m = uniform(random, -reach_m, reach_m);
  const double angle = uniform(random, 0.0, 2.0 * kPi);
  const Eigen::Vector3d approach(std::cos(angle), std::sin(angle), 0.0);
  const double side = uniformIndex(random, 2) == 0 ? 1.0 : -1.0;  // which pad is on which side
  Grasp grasp;
  grasp.X_OT.linear() = toolAxes(approach, side * Eigen::Vector3d::UnitZ().cross(approach));
  grasp.X_OT.translation() =
      along_m * Eigen::Vector3d::UnitZ() + (stick_.finger_depth_m - stick_.radius_m) * approach;
  grasp.opening_m = 2.0 * (stick_.radius_m + stick_.pad_clearance_m);
  return grasp;
}

std::vector<Grasp> drawGrasps(const GraspSampler& sampler, int count, std::uint64_t seed) {
  if (!sampler.all().empty()) return sampler.all();
  std::mt19937_64 random(seed);
  std::vector<Grasp> grasps;
  for (int i = 0; i < count; ++i) grasps.push_back(sampler.sample(random));
  return grasps;
}

std::unique_ptr<const GraspSampler> makeGraspSampler(const GraspSource& source, double max_opening_m) {
  if (source.family == GraspFamily::kPolygonEdges)
    return std::make_unique<PolygonEdgeGraspSampler>(source.polygon_m, source.pad_clearance_m);
  if (source.family == GraspFamily::kStick)
    return std::make_unique<StickGraspSampler>(
        StickGrasps{source.stick_length_m, source.stick_radius_m, source.margin_m, source.finger_depth_m,
                    source.pad_clearance_m},
        max_opening_m);
  if (source.family == GraspFamily::kListed) return std::make_unique<ListedGraspSampler>(source.listed);
  return std::make_unique<BoxGraspSampler>(source.box_size_m, source.finger_depth_m, source.pad_clearance_m,
                                           max_opening_m);
}

}  // namespace b4p
