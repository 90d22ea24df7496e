// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/verification/kinematics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "robots/input_error.h"

namespace b4p::verification {
namespace {

int requireIndex(int index, const char* kind, const std::string& name, const std::string& file) {
  if (index < 0) throw InputError(file, std::string(kind) + " '" + name + "'", "does not exist");
  return index;
}

}  // namespace

Kinematics::Kinematics(const std::string& urdf_file, const ManipulatorDescription& description,
                       const Eigen::Isometry3d& X_WB)
    : tree_(readUrdf(urdf_file)), X_WB_(X_WB), role_(tree_.joints.size(), kResting) {
  const auto jointNamed = [&](const std::string& name) {
    return requireIndex(tree_.jointIndex(name), "joint", name, urdf_file);
  };
  for (const std::string& name : description.joints) {
    const int joint = jointNamed(name);
    role_[joint] = dof();
    planned_.push_back(joint);
  }
  for (const UrdfJoint& joint : tree_.joints) rest_.push_back(std::clamp(0.0, joint.lower, joint.upper));
  for (const auto& [name, value] : description.rest) rest_[jointNamed(name)] = value;
  for (const std::string& name : description.finger_joints) role_[jointNamed(name)] = kFinger;
  tcp_link_ = requireIndex(tree_.linkIndex(description.tcp_link), "link", description.tcp_link, urdf_file);
}

double Kinematics::value(int joint, const Eigen::VectorXd& q, double opening_m) const {
  const int role = role_[joint];
  if (role >= 0) return q[role];
  return role == kFinger ? opening_m / 2.0 : rest_[joint];
}

std::vector<Eigen::Isometry3d> Kinematics::linkPoses(const Eigen::VectorXd& q, double opening_m) const {
  std::vector<Eigen::Isometry3d> X_WL(tree_.links.size(), X_WB_);
  for (const int link : tree_.root_first) {
    const int index = tree_.links[link].parent_joint;
    if (index < 0) continue;
    const UrdfJoint& joint = tree_.joints[index];
    Eigen::Isometry3d& X = X_WL[link];
    X = X_WL[joint.parent_link] * joint.X_PJ;
    if (joint.type == UrdfJointType::kRevolute)
      X.rotate(Eigen::AngleAxisd(value(index, q, opening_m), joint.axis));
    if (joint.type == UrdfJointType::kPrismatic) X.translate(value(index, q, opening_m) * joint.axis);
  }
  return X_WL;
}

Eigen::VectorXd Kinematics::motionPerUnit(int link, double radius_m) const {
  Eigen::VectorXd bound = Eigen::VectorXd::Zero(dof());
  // The farthest that the point can be from the origin of the link reached on the way to the root.
  double reach_m = radius_m;
  for (int index = tree_.links[link].parent_joint; index >= 0;) {
    const UrdfJoint& joint = tree_.joints[index];
    const bool slides = joint.type == UrdfJointType::kPrismatic;
    const int role = role_[index];
    if (role >= 0 && joint.type != UrdfJointType::kFixed) bound[role] = slides ? 1.0 : reach_m;
    reach_m += joint.X_PJ.translation().norm();
    if (slides) reach_m += std::max(std::abs(joint.lower), std::abs(joint.upper));
    index = tree_.links[joint.parent_link].parent_joint;
  }
  return bound;
}

}  // namespace b4p::verification
