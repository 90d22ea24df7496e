// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/verification/reach_checks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "experiments/verification/number_text.h"

namespace b4p::verification {
namespace {

using Eigen::Isometry3d;

constexpr double kPi = 3.14159265358979323846;
constexpr double kStartTolerance = 1e-9;   // rad or m
constexpr double kRounding = 1e-9;         // m or rad, beyond the task's tolerance
constexpr double kStatedTolerance = 1e-6;  // m, and entries of rotation matrices

std::string startProblem(const ReachTask& task, const PlanResult& result) {
  const std::vector<double>& first = result.path.front();
  for (std::size_t j = 0; j < first.size(); ++j)
    if (!(std::abs(first[j] - task.start[j]) <= kStartTolerance))
      return "way-point 0: joint '" + result.joint_names[j] + "' at " + text(first[j]) +
             " is not at the scene's start, " + text(task.start[j]);
  return "";
}

double angleTo(const Eigen::Matrix3d& goal, const Eigen::Matrix3d& R) {
  return Eigen::Quaterniond(goal).angularDistance(Eigen::Quaterniond(R));
}

/// What keeps the TCP at X_WT from being at a grasp, or nothing.
std::string missProblem(const ReachTask& task, const Isometry3d& grasp, const Isometry3d& X_WT) {
  const double distance_m = (grasp.translation() - X_WT.translation()).norm();
  if (!(distance_m <= task.position_tolerance_m + kRounding)) return text(distance_m * 1e3) + " mm";
  if (task.orientation_free) return "";
  double angle_rad = angleTo(grasp.linear(), X_WT.linear());
  if (task.flip) {
    const Eigen::Matrix3d flipped = grasp.linear() * Eigen::AngleAxisd(kPi, Eigen::Vector3d::UnitZ());
    angle_rad = std::min(angle_rad, angleTo(flipped, X_WT.linear()));
  }
  if (!(angle_rad <= task.angle_tolerance_rad + kRounding)) return text(angle_rad * 180.0 / kPi) + " degrees";
  return "";
}

std::string endProblem(const ReachTask& task, const PlanResult& result, const Isometry3d& X_WT) {
  const int grasps = static_cast<int>(task.X_WT.size());
  if (result.grasp_id < 0 || result.grasp_id >= grasps)
    return "grasp_id: " + std::to_string(result.grasp_id) + " is none of the " + std::to_string(grasps) +
           " grasps";
  const Isometry3d& grasp = task.X_WT[static_cast<std::size_t>(result.grasp_id)];
  if (const std::string off = missProblem(task, grasp, X_WT); !off.empty())
    return "way-point " + std::to_string(result.path.size() - 1) + ": the TCP is " + off +
           " away from grasp " + std::to_string(result.grasp_id);
  if (!result.X_WT_reached) return "X_WT_reached: is missing";
  const double difference = (result.X_WT_reached->matrix() - X_WT.matrix()).cwiseAbs().maxCoeff();
  if (!(difference <= kStatedTolerance))
    return "X_WT_reached: differs by " + text(difference) + " from the TCP's pose at the path's end";
  return "";
}

}  // namespace

std::string reachProblem(const ReachTask& task, const PlanResult& result, const Kinematics& robot,
                         double max_opening_m) {
  if (const std::string problem = startProblem(task, result); !problem.empty()) return problem;
  const std::vector<double>& last = result.path.back();
  const Eigen::VectorXd q =
      Eigen::Map<const Eigen::VectorXd>(last.data(), static_cast<Eigen::Index>(last.size()));
  return endProblem(task, result, robot.linkPoses(q, max_opening_m)[robot.tcpLink()]);
}

}  // namespace b4p::verification
