// SPDX-License-Identifier: BSD-3-Clause
#include "robots/kdl_chain.h"

#include <algorithm>

namespace b4p {
namespace {

KDL::Vector toKdl(const Eigen::Vector3d& v) { return KDL::Vector(v.x(), v.y(), v.z()); }

KDL::Joint toKdl(const Joint& joint, const KDL::Frame& origin) {
  const KDL::Vector axis = origin.M * toKdl(joint.axis);
  switch (joint.type) {
    case JointType::kRevolute:
      return KDL::Joint(joint.name, origin.p, axis, KDL::Joint::RotAxis);
    case JointType::kPrismatic:
      return KDL::Joint(joint.name, origin.p, axis, KDL::Joint::TransAxis);
    case JointType::kFixed:
      break;
  }
  return KDL::Joint(joint.name, KDL::Joint::Fixed);
}

}  // namespace

KDL::Frame toKdl(const Eigen::Isometry3d& pose) {
  const Eigen::Matrix3d& R = pose.linear();
  return KDL::Frame(
      KDL::Rotation(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)),
      toKdl(Eigen::Vector3d(pose.translation())));
}

Eigen::Isometry3d fromKdl(const KDL::Frame& frame) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int row = 0; row < 3; ++row) {
    pose.translation()[row] = frame.p(row);
    for (int column = 0; column < 3; ++column) pose.linear()(row, column) = frame.M(row, column);
  }
  return pose;
}

KdlChain::KdlChain(const Manipulator& robot) {
  const RobotModel& model = robot.model();
  std::vector<int> path;
  for (int link = robot.tcpLink(); model.links[static_cast<std::size_t>(link)].parent_joint >= 0;) {
    path.push_back(model.links[static_cast<std::size_t>(link)].parent_joint);
    link = model.joints[static_cast<std::size_t>(path.back())].parent_link;
  }
  std::reverse(path.begin(), path.end());

  chain.addSegment(
      KDL::Segment(model.links.front().name, KDL::Joint(KDL::Joint::Fixed), toKdl(robot.X_WB())));
  const std::vector<int>& planned = robot.plannedJoints();
  for (const int j : path) {
    const Joint& joint = model.joints[static_cast<std::size_t>(j)];
    const KDL::Frame origin = toKdl(joint.X_PJ);
    chain.addSegment(KDL::Segment(model.links[static_cast<std::size_t>(joint.child_link)].name,
                                  toKdl(joint, origin), origin));
    const auto entry = std::find(planned.begin(), planned.end(), j);
    if (entry != planned.end()) q_index.push_back(static_cast<int>(entry - planned.begin()));
  }
}

void KdlChain::toChain(const double* q, KDL::JntArray& chain_q) const {
  for (std::size_t i = 0; i < q_index.size(); ++i) chain_q(static_cast<unsigned>(i)) = q[q_index[i]];
}

void KdlChain::fromChain(const KDL::JntArray& chain_q, double* q) const {
  for (std::size_t i = 0; i < q_index.size(); ++i) q[q_index[i]] = chain_q(static_cast<unsigned>(i));
}

}  // namespace b4p
