// SPDX-License-Identifier: BSD-3-Clause
#include "robots/aligned_chain.h"

#include <algorithm>

namespace b4p {

AlignedChain::AlignedChain(const Manipulator& robot) {
  const RobotModel& model = robot.model();
  std::vector<int> path;
  for (int j = model.links[static_cast<std::size_t>(robot.tcpLink())].parent_joint; j >= 0;) {
    path.push_back(j);
    const int parent = model.joints[static_cast<std::size_t>(j)].parent_link;
    j = model.links[static_cast<std::size_t>(parent)].parent_joint;
  }
  std::reverse(path.begin(), path.end());

  const std::vector<int>& planned = robot.plannedJoints();
  Eigen::Isometry3d X = robot.X_WB();  // what is fixed since the joint before
  for (const int j : path) {
    const Joint& joint = model.joints[static_cast<std::size_t>(j)];
    X = X * joint.X_PJ;
    if (joint.type == JointType::kFixed) continue;
    const Eigen::Quaterniond to_axis =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), joint.axis);
    const auto entry = std::find(planned.begin(), planned.end(), j);
    joints_.push_back(
        {X * to_axis, joint.type == JointType::kRevolute, static_cast<int>(entry - planned.begin())});
    X = Eigen::Isometry3d(to_axis.conjugate());
  }
  X_LT_ = X;
}

std::vector<Eigen::Isometry3d> AlignedChain::frames(const double* q) const {
  std::vector<Eigen::Isometry3d> frames;
  Eigen::Isometry3d X_W = Eigen::Isometry3d::Identity();
  for (const MovingJoint& joint : joints_) {
    X_W = X_W * joint.X_PJ;
    frames.push_back(X_W);
    move(joint, q[joint.q_index], X_W);
  }
  frames.push_back(X_W * X_LT_);
  return frames;
}

}  // namespace b4p
