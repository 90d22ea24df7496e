// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/certification/planar/planar_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "experiments/certification/planar/shape_slice.h"

namespace b4p::planar {
namespace {

// What the verifier forgives at both ends of a path.
constexpr double kTolerance_m = 1e-3;
constexpr double kTolerance_rad = 0.2 * kPi / 180.0;

constexpr double kLevel = 1e-9;
constexpr int kDof = 3;

using Points = std::vector<Eigen::Vector3d>;

const Joint& plannedJoint(const Manipulator& robot, int i) {
  return robot.model().joints[static_cast<std::size_t>(robot.plannedJoints()[static_cast<std::size_t>(i)])];
}

/// Poses of all links with every planned joint at 0.
std::vector<Eigen::Isometry3d> linkPosesAtZero(const Manipulator& robot, double opening_m) {
  std::vector<Eigen::Isometry3d> X_WL;
  const std::array<double, kDof> q{};
  robot.linkPoses(q.data(), opening_m, X_WL);
  return X_WL;
}

const Eigen::Isometry3d& at(const std::vector<Eigen::Isometry3d>& X_WL, int link) {
  return X_WL[static_cast<std::size_t>(link)];
}

/// In the world, with every planned joint at 0.
Eigen::Vector3d axisOf(const Manipulator& robot, int i) {
  const Joint& joint = plannedJoint(robot, i);
  return at(linkPosesAtZero(robot, 0.0), joint.child_link).linear() * joint.axis;
}

/// Pose X_WC of the body frame with every planned joint at 0.
Eigen::Isometry3d bodyPoseAtZero(const Manipulator& robot, const std::vector<Eigen::Isometry3d>& X_WL) {
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  X_WC.translation().head<2>() = at(X_WL, plannedJoint(robot, kDof - 1).child_link).translation().head<2>();
  return X_WC;
}

/// Whether the last planned joint moves a link.
bool carried(const Manipulator& robot, int link) {
  const RobotModel& model = robot.model();
  for (int joint = model.links[static_cast<std::size_t>(link)].parent_joint; joint >= 0;) {
    if (joint == robot.plannedJoints().back()) return true;
    const int parent = model.joints[static_cast<std::size_t>(joint)].parent_link;
    joint = model.links[static_cast<std::size_t>(parent)].parent_joint;
  }
  return false;
}

Points placed(const PlacedShape& shape, const Eigen::Isometry3d& X) {
  Points points = innerPoints(shape.shape);
  for (Eigen::Vector3d& point : points) point = X * (shape.X_BS * point);
  return points;
}

std::vector<Points> bodyParts(const Scene& scene, const Manipulator& robot, const Grasp& grasp) {
  const auto X_WL = linkPosesAtZero(robot, grasp.opening_m);
  const Eigen::Isometry3d X_CW = bodyPoseAtZero(robot, X_WL).inverse();
  std::vector<Points> parts;
  for (std::size_t link = 0; link < X_WL.size(); ++link)
    if (carried(robot, static_cast<int>(link)))
      for (const PlacedShape& shape : robot.model().links[link].shapes)
        parts.push_back(placed(shape, X_CW * X_WL[link]));
  const Eigen::Isometry3d X_CO = X_CW * at(X_WL, robot.tcpLink()) * grasp.X_OT.inverse();
  for (const PlacedShape& shape : scene.pickPlace().object) parts.push_back(placed(shape, X_CO));
  return parts;
}

/// Halfway between every two neighbouring ends of parts.
std::vector<double> heights(const std::vector<Points>& moving, const std::vector<Points>& fixed) {
  std::set<double> ends;
  for (const auto* parts : {&moving, &fixed})
    for (const Points& part : *parts) {
      const auto [low, high] = std::minmax_element(
          part.begin(), part.end(), [](const auto& a, const auto& b) { return a.z() < b.z(); });
      ends.insert(low->z());
      ends.insert(high->z());
    }
  std::vector<double> middles;
  for (auto end = ends.begin(); end != ends.end() && std::next(end) != ends.end(); ++end)
    if (*std::next(end) - *end > kLevel) middles.push_back((*end + *std::next(end)) / 2.0);
  return middles;
}

std::vector<Polygon> cut(const std::vector<Points>& parts, double z) {
  std::vector<Polygon> polygons;
  for (const Points& part : parts) {
    Polygon polygon = cutAt(part, z);
    if (polygon.size() >= 3) polygons.push_back(std::move(polygon));
  }
  return polygons;
}

std::vector<Slice> slices(const std::vector<Points>& moving, const std::vector<Points>& fixed) {
  std::vector<Slice> result;
  for (const double z : heights(moving, fixed)) {
    Slice slice{cut(moving, z), cut(fixed, z)};
    const auto same = [&slice](const Slice& other) {
      return other.moving == slice.moving && other.fixed == slice.fixed;
    };
    if (slice.moving.empty() || slice.fixed.empty()) continue;
    if (std::none_of(result.begin(), result.end(), same)) result.push_back(std::move(slice));
  }
  return result;
}

/// Positions of the body frame over all values of the sliding joints lie between these.
void setLimits(const Manipulator& robot, const Eigen::Isometry3d& X_WC_zero, PlanarTask& task) {
  task.min_m = task.max_m = X_WC_zero.translation().head<2>();
  for (int i = 0; i < kDof - 1; ++i) {
    const Eigen::Vector2d axis = axisOf(robot, i).head<2>();
    const Eigen::Vector2d one = robot.lower()[i] * axis, other = robot.upper()[i] * axis;
    task.min_m += one.cwiseMin(other);
    task.max_m += one.cwiseMax(other);
  }
}

Pose startPose(const Eigen::Isometry3d& X_WC) {
  const Eigen::Vector3d up = X_WC.linear().col(2);
  if (std::abs(X_WC.translation().z()) > kTolerance_m || std::hypot(up.x(), up.y()) > kTolerance_rad ||
      up.z() < 0.0)
    throw std::invalid_argument("the grasp is out of the robot's plane at the object's start pose");
  return {X_WC.translation().head<2>(), std::atan2(X_WC.linear()(1, 0), X_WC.linear()(0, 0))};
}

/// The window of yaw is about the start orientation, which a start that is not upright does not keep.
void setGoal(const Scene& scene, PlanarTask& task) {
  const PlacementSource& placement = scene.pickPlace().placement;
  task.goal_min_m = placement.min_m.head<2>();
  task.goal_max_m = placement.max_m.head<2>();
  const Eigen::Vector3d up = scene.pickPlace().X_WO_start.linear().col(2);
  if (placement.upright && (std::hypot(up.x(), up.y()) > kLevel || up.z() < 0.0)) return;
  task.goal_angle_rad = task.start.angle_rad + (placement.yaw_min_rad + placement.yaw_max_rad) / 2.0;
  task.goal_half_angle_rad = (placement.yaw_max_rad - placement.yaw_min_rad) / 2.0;
}

}  // namespace

std::string whyNotPlanar(const Manipulator& robot) {
  if (robot.dof() != kDof) return "the robot has " + std::to_string(robot.dof()) + " planned joints, not 3";
  for (int i = 0; i < kDof; ++i) {
    const Joint& joint = plannedJoint(robot, i);
    const bool last = i == kDof - 1;
    if (joint.type != (last ? JointType::kRevolute : JointType::kPrismatic))
      return "joint '" + joint.name + "' does not " + (last ? "turn" : "slide");
    const Eigen::Vector3d axis = axisOf(robot, i);
    if (last ? std::hypot(axis.x(), axis.y()) > kLevel : std::abs(axis.z()) > kLevel)
      return "joint '" + joint.name + "' is not " + (last ? "vertical" : "level");
  }
  // An axis that an earlier joint turned would not stay level and straight; none turns before the last.
  return "";
}

PlanarTask planarTask(const Scene& scene, const Manipulator& robot, const Grasp& grasp) {
  const auto X_WL = linkPosesAtZero(robot, grasp.opening_m);
  const Eigen::Isometry3d X_WC_zero = bodyPoseAtZero(robot, X_WL);
  const Eigen::Isometry3d X_CT = X_WC_zero.inverse() * at(X_WL, robot.tcpLink());
  std::vector<Points> fixed;
  for (const Obstacle& obstacle : scene.obstacles)
    fixed.push_back(placed(obstacle.shape, Eigen::Isometry3d::Identity()));

  PlanarTask task;
  task.slices = slices(bodyParts(scene, robot, grasp), fixed);
  setLimits(robot, X_WC_zero, task);
  task.start = startPose(scene.pickPlace().X_WO_start * grasp.X_OT * X_CT.inverse());
  task.point_m = (X_CT * grasp.X_OT.inverse()).translation().head<2>();
  setGoal(scene, task);
  task.tolerance_m = kTolerance_m;
  task.tolerance_rad = kTolerance_rad;
  return task;
}

}  // namespace b4p::planar
