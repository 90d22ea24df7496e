// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/link_groups.h"

#include <algorithm>
#include <string>

namespace b4p {
namespace {

const Joint* parentJoint(const Manipulator& robot, int link) {
  const int joint = robot.model().links[static_cast<std::size_t>(link)].parent_joint;
  return joint < 0 ? nullptr : &robot.model().joints[static_cast<std::size_t>(joint)];
}

// The uppermost link that the given one is fixed to.
int fixedTo(const Manipulator& robot, int link) {
  for (const Joint* joint = parentJoint(robot, link); joint && joint->type == JointType::kFixed;
       joint = parentJoint(robot, link))
    link = joint->parent_link;
  return link;
}

// The link that carries the given one's group, its own fixed links left out; -1 for the root's.
int carrierOf(const Manipulator& robot, int link) {
  const Joint* joint = parentJoint(robot, fixedTo(robot, link));
  return joint ? fixedTo(robot, joint->parent_link) : -1;
}

}  // namespace

int plannedIndex(const Manipulator& robot, int joint) {
  const std::vector<int>& planned = robot.plannedJoints();
  const auto found = std::find(planned.begin(), planned.end(), joint);
  return found == planned.end() ? -1 : static_cast<int>(found - planned.begin());
}

bool isFingerJoint(const Manipulator& robot, int joint) {
  const std::vector<std::string>& fingers = robot.description().finger_joints;
  const std::string& name = robot.model().joints[static_cast<std::size_t>(joint)].name;
  return std::find(fingers.begin(), fingers.end(), name) != fingers.end();
}

std::vector<int> planningJointsAbove(const Manipulator& robot, int link) {
  std::vector<int> indices;
  const RobotModel& model = robot.model();
  for (int joint = model.links[static_cast<std::size_t>(link)].parent_joint; joint >= 0;) {
    if (const int index = plannedIndex(robot, joint); index >= 0) indices.push_back(index);
    const int parent = model.joints[static_cast<std::size_t>(joint)].parent_link;
    joint = model.links[static_cast<std::size_t>(parent)].parent_joint;
  }
  std::sort(indices.begin(), indices.end());
  return indices;
}

bool isMoving(const Manipulator& robot, int link) {
  const RobotModel& model = robot.model();
  for (int joint = model.links[static_cast<std::size_t>(link)].parent_joint; joint >= 0;) {
    if (plannedIndex(robot, joint) >= 0 || isFingerJoint(robot, joint)) return true;
    const int parent = model.joints[static_cast<std::size_t>(joint)].parent_link;
    joint = model.links[static_cast<std::size_t>(parent)].parent_joint;
  }
  return false;
}

bool mayTouch(const Manipulator& robot, int link_a, int link_b) {
  if (planningJointsAbove(robot, link_a) == planningJointsAbove(robot, link_b)) return true;
  const int group_a = fixedTo(robot, link_a), group_b = fixedTo(robot, link_b);
  if (carrierOf(robot, link_a) == group_b || carrierOf(robot, link_b) == group_a) return true;
  const std::vector<Link>& links = robot.model().links;
  const std::string& name_a = links[static_cast<std::size_t>(link_a)].name;
  const std::string& name_b = links[static_cast<std::size_t>(link_b)].name;
  const auto& allowed = robot.description().skip_self_collision;
  return std::any_of(allowed.begin(), allowed.end(), [&](const auto& pair) {
    return (pair.first == name_a && pair.second == name_b) || (pair.first == name_b && pair.second == name_a);
  });
}

}  // namespace b4p
