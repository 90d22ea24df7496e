// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/verification/others_at_rest.h"

#include <filesystem>
#include <set>
#include <string>

#include "experiments/verification/kinematics.h"

namespace b4p::verification {
namespace {

bool partsOfOneRobot(const PlacementArm& a, const PlacementArm& b) {
  std::error_code error;
  return a.X_WB.isApprox(b.X_WB, 1e-9) &&
         (a.urdf_file == b.urdf_file || std::filesystem::equivalent(a.urdf_file, b.urdf_file, error));
}

}  // namespace

ManipulatorDescription withOthersAtRest(const PlacementTask& task, std::size_t arm) {
  const PlacementArm& moving = task.arms.at(arm);
  ManipulatorDescription description = moving.description;
  std::set<std::string> own(description.joints.begin(), description.joints.end());
  own.insert(description.finger_joints.begin(), description.finger_joints.end());
  for (std::size_t i = 0; i < task.arms.size(); ++i) {
    const PlacementArm& other = task.arms[i];
    if (i == arm || !partsOfOneRobot(other, moving)) continue;
    for (std::size_t j = 0; j < other.start.size(); ++j)
      if (own.count(other.description.joints[j]) == 0)
        description.rest[other.description.joints[j]] = other.start[j];
    for (const std::string& finger : other.description.finger_joints)
      if (own.count(finger) == 0) description.rest[finger] = 0.5 * other.rest_opening_m;
  }
  return description;
}

std::vector<StandingBody> otherRobots(const PlacementTask& task, std::size_t arm) {
  std::vector<StandingBody> bodies;
  for (std::size_t i = 0; i < task.arms.size(); ++i) {
    const PlacementArm& other = task.arms[i];
    if (partsOfOneRobot(other, task.arms.at(arm))) continue;
    // Of a robot with several arms each stands here once for every one of them, at the same place.
    const Kinematics robot(other.urdf_file, withOthersAtRest(task, i), other.X_WB);
    const Eigen::VectorXd q =
        Eigen::Map<const Eigen::VectorXd>(other.start.data(), static_cast<Eigen::Index>(other.start.size()));
    const auto X_WL = robot.linkPoses(q, other.rest_opening_m);
    for (std::size_t link = 0; link < X_WL.size(); ++link)
      for (const PlacedBody& placed : robot.tree().links[link].bodies)
        bodies.push_back({"arm '" + other.name + "', link '" + robot.tree().links[link].name + "'",
                          {placed.body, X_WL[link] * placed.X_LS}});
  }
  return bodies;
}

}  // namespace b4p::verification
