// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/verification/task_checks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>

#include "experiments/verification/number_text.h"

namespace b4p::verification {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;
constexpr double kPositionTolerance_m = 1e-3;
constexpr double kAngleTolerance_rad = 0.2 * kPi / 180.0;
constexpr double kLimitTolerance = 1e-9;  // rad or m
constexpr double kGraspTolerance = 1e-6;  // m, and entries of rotation matrices

double degrees(double angle_rad) { return angle_rad * 180.0 / kPi; }

double angleBetween(const Isometry3d& a, const Isometry3d& b) {
  return Eigen::Quaterniond(a.linear()).angularDistance(Eigen::Quaterniond(b.linear()));
}

/// What separates two poses by more than the tolerances, or nothing.
std::string poseDifference(const Isometry3d& a, const Isometry3d& b) {
  const double distance_m = (a.translation() - b.translation()).norm();
  if (!(distance_m <= kPositionTolerance_m)) return text(distance_m * 1e3) + " mm";
  const double angle_rad = angleBetween(a, b);
  if (!(angle_rad <= kAngleTolerance_rad)) return text(degrees(angle_rad)) + " degrees";
  return "";
}

bool isPose(const Isometry3d& X) {
  const Eigen::Matrix3d R = X.linear();
  return X.matrix().allFinite() &&
         (R * R.transpose() - Eigen::Matrix3d::Identity()).norm() <= kGraspTolerance && R.determinant() > 0.0;
}

std::string boxGraspProblem(const GraspSource& source, const Grasp& grasp) {
  const Vector3d closing = grasp.X_OT.linear().col(1), p_OT = grasp.X_OT.translation();
  int along = 0;
  const double aligned = closing.cwiseAbs().maxCoeff(&along);
  if ((closing - std::copysign(aligned, closing[along]) * Vector3d::Unit(along)).norm() > kGraspTolerance)
    return "grasp: the pads do not face two sides of the box";
  const double size_m = source.box_size_m[along];
  const double gap_m = grasp.opening_m - size_m;
  if (gap_m < -kGraspTolerance)
    return "grasp: opening of " + text(grasp.opening_m) + " m is less than the box's " + text(size_m) + " m";
  if (gap_m > 2.0 * source.pad_clearance_m + kGraspTolerance)
    return "grasp: opening of " + text(grasp.opening_m) + " m does not hold the box's " + text(size_m) + " m";
  if (2.0 * std::abs(p_OT[along]) > gap_m + kGraspTolerance)
    return "grasp: a pad lies inside the box, the TCP is " + text(p_OT[along]) + " m off its middle";
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(p_OT[axis]) > source.box_size_m[axis] / 2.0 + kGraspTolerance)
      return "grasp: the TCP is outside the box, " + text(p_OT[axis]) + " m from its centre";
  return "";
}

std::string stickGraspProblem(const GraspSource& source, const Grasp& grasp) {
  const Vector3d closing = grasp.X_OT.linear().col(1), approach = grasp.X_OT.linear().col(2);
  const Vector3d p_OT = grasp.X_OT.translation();
  if (std::abs(closing.z()) > kGraspTolerance) return "grasp: the pads do not close across the stick";
  if (std::abs(approach.z()) > kGraspTolerance) return "grasp: the hand does not stand across the stick";
  const double past_end_m = std::abs(p_OT.z()) - (source.stick_length_m / 2.0 - source.margin_m);
  if (past_end_m > kGraspTolerance)
    return "grasp: the TCP is " + text(past_end_m) + " m past the margin at the stick's end";
  const double gap_m = grasp.opening_m - 2.0 * source.stick_radius_m;
  if (gap_m < -kGraspTolerance)
    return "grasp: opening of " + text(grasp.opening_m) + " m is less than the stick is thick";
  if (gap_m > 2.0 * source.pad_clearance_m + kGraspTolerance)
    return "grasp: opening of " + text(grasp.opening_m) + " m does not hold the stick";
  const double off_m = p_OT.dot(closing);
  if (2.0 * std::abs(off_m) > gap_m + kGraspTolerance)
    return "grasp: a pad lies inside the stick, the TCP is " + text(off_m) + " m off its axis";
  if (std::abs(p_OT.dot(approach)) > source.stick_radius_m + kGraspTolerance)
    return "grasp: the stick is not between the pads";
  return "";
}

/// The gripper's front against the middle of edge `id` from outside.
Isometry3d edgeGrasp(const GraspSource& source, std::size_t id) {
  const Eigen::Vector2d& a = source.polygon_m[id];
  const Eigen::Vector2d& b = source.polygon_m[(id + 1) % source.polygon_m.size()];
  const Eigen::Vector2d middle = (a + b) / 2.0, along = (b - a).normalized();
  const Vector3d approach(-along.y(), along.x(), 0.0);  // inwards: the outline runs counter-clockwise
  Isometry3d X_OT = Isometry3d::Identity();
  X_OT.linear().col(0) = -Vector3d::UnitZ();
  X_OT.linear().col(1) = -Vector3d(along.x(), along.y(), 0.0);
  X_OT.linear().col(2) = approach;
  X_OT.translation() = Vector3d(middle.x(), middle.y(), 0.0) - source.pad_clearance_m * approach;
  return X_OT;
}

std::string edgeGraspProblem(const GraspSource& source, const PlanResult& result) {
  const int edges = static_cast<int>(source.polygon_m.size());
  if (result.grasp_id < 0 || result.grasp_id >= edges)
    return "grasp: id " + std::to_string(result.grasp_id) + " is none of the " + std::to_string(edges) +
           " edges";
  const Isometry3d X_OT = edgeGrasp(source, static_cast<std::size_t>(result.grasp_id));
  const double difference = (X_OT.matrix() - result.grasp.X_OT.matrix()).cwiseAbs().maxCoeff();
  if (difference > kGraspTolerance)
    return "grasp: differs by " + text(difference) + " from the one of edge " +
           std::to_string(result.grasp_id);
  if (result.grasp.opening_m > kGraspTolerance)
    return "grasp: opening is " + text(result.grasp.opening_m) +
           " m, an edge is pressed with a closed gripper";
  return "";
}

std::string listedGraspProblem(const GraspSource& source, const PlanResult& result) {
  const std::string row = "row " + std::to_string(result.grasp_id + 1);
  if (result.grasp_id < 0 || result.grasp_id >= static_cast<int>(source.listed.size()))
    return "grasp: " + row + " is none of the " + std::to_string(source.listed.size()) + " listed";
  const Grasp& listed = source.listed[static_cast<std::size_t>(result.grasp_id)];
  const double difference = (listed.X_OT.matrix() - result.grasp.X_OT.matrix()).cwiseAbs().maxCoeff();
  if (difference > kGraspTolerance)
    return "grasp: differs by " + text(difference) + " from the one of " + row;
  if (std::abs(listed.opening_m - result.grasp.opening_m) > kGraspTolerance)
    return "grasp: opening of " + text(result.grasp.opening_m) + " m is not the " + text(listed.opening_m) +
           " m of " + row;
  return "";
}

/// The start orientation, made upright by the shortest turn where the object has to stand.
Eigen::Matrix3d unturnedOrientation(const Scene& scene) {
  const Eigen::Matrix3d R = scene.pickPlace().X_WO_start.linear();
  if (!scene.pickPlace().placement.upright) return R;
  return Eigen::Quaterniond::FromTwoVectors(R.col(2), Vector3d::UnitZ()).toRotationMatrix() * R;
}

/// The part of the turn from `from` to `to` that is about the world's z, in (-pi, pi].
double yawBetween(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) {
  const Eigen::Quaterniond turn(to * from.transpose());
  return std::remainder(2.0 * std::atan2(turn.z(), turn.w()), 2.0 * kPi);
}

bool yawInWindow(double yaw_rad, const PlacementSource& placement) {
  // The window's end is reached by turning on from its beginning.
  const double past = yaw_rad - (placement.yaw_min_rad - kAngleTolerance_rad);
  const double turned = past - 2.0 * kPi * std::floor(past / (2.0 * kPi));
  return turned <= placement.yaw_max_rad - placement.yaw_min_rad + 2.0 * kAngleTolerance_rad;
}

std::string placementProblem(const Scene& scene, const Isometry3d& X_WO) {
  const PlacementSource& placement = scene.pickPlace().placement;
  const Vector3d p = X_WO.translation();
  for (int axis = 0; axis < 3; ++axis)
    if (!(p[axis] >= placement.min_m[axis] - kPositionTolerance_m &&
          p[axis] <= placement.max_m[axis] + kPositionTolerance_m))
      return std::string("is outside the placement region: ") + "xyz"[axis] + " = " + text(p[axis]) + " m";
  const Vector3d up = X_WO.linear().col(2);
  const double tilt_rad = std::atan2(std::hypot(up.x(), up.y()), up.z());
  if (placement.upright && !(tilt_rad <= kAngleTolerance_rad))
    return "is not upright: tilted by " + text(degrees(tilt_rad)) + " degrees";
  const double yaw_rad = yawBetween(unturnedOrientation(scene), X_WO.linear());
  if (!yawInWindow(yaw_rad, placement))
    return "is turned out of the window of yaw: " + text(yaw_rad) + " rad";
  return "";
}

/// By its own name, by its file, or as those that ship are called: by the file without its extension, with or
/// without the folders that lead to it.
bool namesScene(const std::string& name_or_path, const Scene& scene) {
  const std::string bare = "/" + std::filesystem::path(scene.file).replace_extension().generic_string();
  const std::string end = "/" + name_or_path;
  std::error_code error;
  return name_or_path == scene.name || name_or_path == scene.file ||
         (bare.size() >= end.size() && bare.compare(bare.size() - end.size(), end.size(), end) == 0) ||
         std::filesystem::equivalent(name_or_path, scene.file, error);
}

}  // namespace

std::string statusProblem(const Scene& scene, const PlanResult& result) {
  if (!namesScene(result.scene, scene)) return "scene: '" + result.scene + "' is not '" + scene.name + "'";
  if (!result.solved) return "solved: false, there is no path to verify";
  if (result.status != kExactSolution)
    return "status: '" + result.status + "' is not '" + kExactSolution + "'";
  return "";
}

std::string rowsProblem(const Scene& scene, const PlanResult& result, const Kinematics& robot) {
  const std::vector<std::string>& joints = scene.robot.description.joints;
  if (result.joint_names.size() != joints.size())
    return "joint_names: " + std::to_string(result.joint_names.size()) + " names, the robot has " +
           std::to_string(joints.size());
  for (std::size_t j = 0; j < joints.size(); ++j)
    if (result.joint_names[j] != joints[j])
      return "joint_names: '" + result.joint_names[j] + "' stands where the robot has '" + joints[j] + "'";
  if (result.path.empty()) return "path: has no way-point";
  for (std::size_t i = 0; i < result.path.size(); ++i) {
    const std::string where = "way-point " + std::to_string(i) + ": ";
    const std::vector<double>& row = result.path[i];
    if (row.size() != joints.size())
      return where + std::to_string(row.size()) + " values for " + std::to_string(joints.size()) + " joints";
    for (std::size_t j = 0; j < row.size(); ++j) {
      const UrdfJoint& joint = robot.plannedJoint(static_cast<int>(j));
      if (!std::isfinite(row[j])) return where + "joint '" + joint.name + "' is not finite: " + text(row[j]);
      if (row[j] < joint.lower - kLimitTolerance || row[j] > joint.upper + kLimitTolerance)
        return where + "joint '" + joint.name + "' at " + text(row[j]) + " is outside its limits [" +
               text(joint.lower) + ", " + text(joint.upper) + "]";
    }
  }
  return "";
}

std::string graspProblem(const Scene& scene, const PlanResult& result, const Kinematics& robot) {
  const Grasp& grasp = result.grasp;
  const ManipulatorDescription& gripper = scene.robot.description;
  if (!isPose(grasp.X_OT)) return "grasp: X_OT is not a pose";
  if (!(grasp.opening_m >= 0.0 && grasp.opening_m <= gripper.max_opening_m + kLimitTolerance))
    return "grasp: opening of " + text(grasp.opening_m) + " m is outside [0, " + text(gripper.max_opening_m) +
           "]";
  for (const std::string& name : gripper.finger_joints) {
    const UrdfJoint& finger = robot.tree().joints[robot.tree().jointIndex(name)];
    const double value = grasp.opening_m / 2.0;
    if (value < finger.lower - kLimitTolerance || value > finger.upper + kLimitTolerance)
      return "grasp: joint '" + name + "' at " + text(value) + " is outside its limits";
  }
  switch (scene.pickPlace().grasps.family) {
    case GraspFamily::kBox:
      return boxGraspProblem(scene.pickPlace().grasps, grasp);
    case GraspFamily::kStick:
      return stickGraspProblem(scene.pickPlace().grasps, grasp);
    case GraspFamily::kPolygonEdges:
      return edgeGraspProblem(scene.pickPlace().grasps, result);
    case GraspFamily::kListed:
      return listedGraspProblem(scene.pickPlace().grasps, result);
  }
  return "grasp: of no known family";
}

std::string endsProblem(const Scene& scene, const PlanResult& result, const Isometry3d& X_WO_first,
                        const Isometry3d& X_WO_last) {
  const std::string first = "way-point 0: ";
  const std::string last = "way-point " + std::to_string(result.path.size() - 1) + ": ";
  if (const std::string off = poseDifference(X_WO_first, scene.pickPlace().X_WO_start); !off.empty())
    return first + "the object is " + off + " away from where it is picked up";
  if (const std::string problem = placementProblem(scene, X_WO_last); !problem.empty())
    return last + "the object " + problem;
  if (!isPose(result.X_WO_pick)) return "X_WO_pick: is not a pose";
  if (!isPose(result.X_WO_place)) return "X_WO_place: is not a pose";
  if (const std::string off = poseDifference(X_WO_first, result.X_WO_pick); !off.empty())
    return "X_WO_pick: is " + off + " away from the path's first object pose";
  if (const std::string off = poseDifference(X_WO_last, result.X_WO_place); !off.empty())
    return "X_WO_place: is " + off + " away from the path's last object pose";
  return "";
}

}  // namespace b4p::verification
