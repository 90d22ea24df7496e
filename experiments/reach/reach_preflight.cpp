// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/reach/reach_preflight.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "robots/input_error.h"
#include "robots/number_text.h"
#include "robots/robot_model.h"

namespace b4p {
namespace {

constexpr const char* kStart = "reach.start";

/// No configuration brings the TCP farther from the origin of the root link than this (m).
double longestReach(const Manipulator& robot) {
  const RobotModel& model = robot.model();
  double length_m = 0.0;
  for (int link = robot.tcpLink(); model.links[static_cast<std::size_t>(link)].parent_joint >= 0;) {
    const Joint& joint =
        model.joints[static_cast<std::size_t>(model.links[static_cast<std::size_t>(link)].parent_joint)];
    length_m += joint.X_PJ.translation().norm();
    if (joint.type == JointType::kPrismatic)
      length_m += std::max(std::abs(joint.lower), std::abs(joint.upper));
    link = joint.parent_link;
  }
  return length_m;
}

/// How the files call a grasp.
std::pair<std::string, std::string> placeOf(const Scene& scene, const ReachTask& task, std::size_t grasp) {
  if (task.orientation_free) return {scene.file, "reach.positions_m[" + std::to_string(grasp) + "]"};
  return {task.grasp_file, "row " + std::to_string(grasp + 1)};
}

}  // namespace

void requireStartInsideLimits(const Scene& scene, const ReachTask& task, const Manipulator& robot) {
  for (int i = 0; i < robot.dof(); ++i) {
    const double value = task.start[static_cast<std::size_t>(i)];
    if (value >= robot.lower()[i] && value <= robot.upper()[i]) continue;
    throw InputError(scene.file, kStart,
                     "joint '" + robot.description().joints[static_cast<std::size_t>(i)] + "' at " +
                         numberText(value) + " is outside its limits [" + numberText(robot.lower()[i]) +
                         ", " + numberText(robot.upper()[i]) + "]");
  }
}

void requireFreeStart(const Scene& scene, const ReachTask& task, const CollisionChecker& checker) {
  const std::string collision = checker.makeContext()->describeCollision(task.start.data(), nullptr);
  if (!collision.empty())
    throw InputError(scene.file, kStart,
                     "is in collision (" + collision + "), or nearer to it than half of edge_step_m, " +
                         numberText(scene.edge_step_m / 2.0) + " m");
}

void requireGraspsWithinReach(const Scene& scene, const ReachTask& task, const Manipulator& robot) {
  const double reach_m = longestReach(robot) + task.position_tolerance_m;
  for (std::size_t i = 0; i < task.X_WT.size(); ++i) {
    const double distance_m = (task.X_WT[i].translation() - robot.X_WB().translation()).norm();
    if (distance_m <= reach_m) continue;
    const auto [file, element] = placeOf(scene, task, i);
    throw InputError(file, element,
                     "is out of reach: it is " + numberText(distance_m) +
                         " m from the robot's root, the arm reaches " + numberText(reach_m) + " m at most");
  }
}

}  // namespace b4p
