// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/floating_body.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace b4p {
namespace {

constexpr double kTravel_m = 1e4;  ///< farther than any scene reaches
constexpr double kTurn_rad = 6.3;  ///< a full turn
constexpr const char* kTcp = "floating_tcp";

/// Six joints from a fixed root: position along x, y, z, then rotation about z, y, x.
void addFreeJoints(RobotModel& model, ManipulatorDescription& description) {
  model.links.push_back({"floating_root", {}, -1});
  const std::array<int, 6> axes{0, 1, 2, 2, 1, 0};
  for (int i = 0; i < 6; ++i) {
    Joint joint;
    joint.name = "floating_joint_" + std::to_string(i);
    joint.type = i < 3 ? JointType::kPrismatic : JointType::kRevolute;
    joint.axis = Eigen::Vector3d::Unit(axes[static_cast<std::size_t>(i)]);
    joint.upper = i < 3 ? kTravel_m : kTurn_rad;
    joint.lower = -joint.upper;
    joint.parent_link = i;
    joint.child_link = i + 1;
    model.joints.push_back(joint);
    model.links.push_back({"floating_link_" + std::to_string(i), {}, i});
    description.joints.push_back(joint.name);
  }
}

/// Hangs a fixed, empty TCP link on the last free link; `X_LT` is its pose there.
void addTcp(RobotModel& model, int parent_link, const Eigen::Isometry3d& X_LT) {
  Joint joint;
  joint.name = "floating_tcp_joint";
  joint.X_PJ = X_LT;
  joint.parent_link = parent_link;
  joint.child_link = static_cast<int>(model.links.size());
  model.joints.push_back(joint);
  model.links.push_back({kTcp, {}, static_cast<int>(model.joints.size()) - 1});
}

/// The link that the last moving joint before the TCP carries.
int carriedLink(const Manipulator& robot) {
  int link = robot.tcpLink();
  for (;;) {
    const int joint = robot.model().links[static_cast<std::size_t>(link)].parent_joint;
    if (joint < 0) return link;
    const Joint& parent = robot.model().joints[static_cast<std::size_t>(joint)];
    if (parent.type != JointType::kFixed) return link;
    link = parent.parent_link;
  }
}

/// Copies `from` of the robot, with all that hangs on it, onto link `onto`. Joints come after their parents
/// in a RobotModel, so one pass finds them all.
void copySubtree(const Manipulator& robot, int from, RobotModel& model, int onto,
                 ManipulatorDescription& description) {
  const RobotModel& source = robot.model();
  const ManipulatorDescription& original = robot.description();
  std::vector<int> image(source.links.size(), -1);
  image[static_cast<std::size_t>(from)] = onto;
  Link& first = model.links[static_cast<std::size_t>(onto)];
  first.name = source.links[static_cast<std::size_t>(from)].name;
  first.shapes = source.links[static_cast<std::size_t>(from)].shapes;
  for (Joint joint : source.joints) {
    const int parent = image[static_cast<std::size_t>(joint.parent_link)];
    if (parent < 0) continue;
    Link child = source.links[static_cast<std::size_t>(joint.child_link)];
    image[static_cast<std::size_t>(joint.child_link)] = static_cast<int>(model.links.size());
    child.parent_joint = static_cast<int>(model.joints.size());
    joint.parent_link = parent;
    joint.child_link = static_cast<int>(model.links.size());
    model.joints.push_back(std::move(joint));
    model.links.push_back(std::move(child));
  }
  for (const std::string& joint : original.finger_joints)
    if (model.jointIndex(joint) >= 0) description.finger_joints.push_back(joint);
  for (const std::string& link : original.finger_links)
    if (model.linkIndex(link) >= 0) description.finger_links.push_back(link);
  for (const auto& [a, b] : original.skip_self_collision)
    if (model.linkIndex(a) >= 0 && model.linkIndex(b) >= 0)
      description.skip_self_collision.emplace_back(a, b);
}

}  // namespace

CollisionProblem FloatingBody::floating(const CollisionProblem& problem, Parts parts) {
  RobotModel model;
  model.name = problem.robot->model().name;
  ManipulatorDescription description;
  description.tcp_link = kTcp;
  description.max_opening_m = problem.robot->description().max_opening_m;
  addFreeJoints(model, description);
  const int last = static_cast<int>(model.links.size()) - 1;
  Eigen::Isometry3d X_LT = Eigen::Isometry3d::Identity();
  if (parts == Parts::kGripper) {
    const int carried = carriedLink(*problem.robot);
    std::vector<Eigen::Isometry3d> X_WL;
    const Eigen::VectorXd q = (problem.robot->lower() + problem.robot->upper()) / 2.0;
    problem.robot->linkPoses(q.data(), 0.0, X_WL);
    X_LT = X_WL[static_cast<std::size_t>(carried)].inverse() *
           X_WL[static_cast<std::size_t>(problem.robot->tcpLink())];
    copySubtree(*problem.robot, carried, model, last, description);
  }
  addTcp(model, last, X_LT);
  CollisionProblem body = problem;
  body.robot = std::make_shared<Manipulator>(std::move(model), std::move(description),
                                             Eigen::Isometry3d::Identity(), "floating body");
  return body;
}

std::shared_ptr<const CollisionChecker> FloatingBody::makeChecker(const CollisionProblem& problem,
                                                                  Parts parts) {
  return makeVectorChecker(floating(problem, parts));
}

std::shared_ptr<const CollisionChecker> FloatingBody::makeChecker(const CollisionProblem& problem,
                                                                  Parts parts, const CollisionChecker& like) {
  return like.sameKindFor(floating(problem, parts));
}

std::array<double, 6> FloatingBody::placedAt(const Eigen::Isometry3d& X_WT) const {
  const RobotModel& model = robot_->model();
  const Eigen::Isometry3d& X_LT = model.joints.back().X_PJ;
  const Eigen::Isometry3d X_WL = X_WT * X_LT.inverse();
  const Eigen::Vector3d p = X_WL.translation();
  const Eigen::Vector3d zyx = X_WL.linear().eulerAngles(2, 1, 0);
  return {p.x(), p.y(), p.z(), zyx[0], zyx[1], zyx[2]};
}

bool FloatingBody::isFree(const Eigen::Isometry3d& X_WT, const Grasp& grasp) {
  const auto q = placedAt(X_WT);
  return context_->isFree(q.data(), &grasp);
}

void FloatingBody::areFree(const std::vector<Eigen::Isometry3d>& X_WT, const Grasp& grasp,
                           std::vector<bool>& free) {
  q_.clear();
  for (const Eigen::Isometry3d& pose : X_WT) {
    const auto q = placedAt(pose);
    q_.insert(q_.end(), q.begin(), q.end());
  }
  askAll(grasp, free);
}

void FloatingBody::areFreeShifted(const Eigen::Isometry3d& X_WT, const std::vector<Eigen::Vector3d>& shifts_m,
                                  const Grasp& grasp, std::vector<bool>& free) {
  const auto q = placedAt(X_WT);
  q_.clear();
  for (const Eigen::Vector3d& shift_m : shifts_m) {
    q_.insert(q_.end(), {q[0] + shift_m.x(), q[1] + shift_m.y(), q[2] + shift_m.z()});
    q_.insert(q_.end(), q.begin() + 3, q.end());
  }
  askAll(grasp, free);
}

void FloatingBody::askAll(const Grasp& grasp, std::vector<bool>& free) {
  constexpr std::size_t kAtOnce = 64;
  constexpr std::size_t kDof = 6;
  std::array<bool, kAtOnce> answers;
  free.clear();
  for (std::size_t begin = 0; begin < q_.size(); begin += kAtOnce * kDof) {
    const std::size_t count = std::min(kAtOnce, (q_.size() - begin) / kDof);
    context_->areFree(q_.data() + begin, static_cast<int>(count), &grasp, answers.data());
    free.insert(free.end(), answers.begin(), answers.begin() + static_cast<std::ptrdiff_t>(count));
  }
}

std::string FloatingBody::describeCollision(const Eigen::Isometry3d& X_WT, const Grasp& grasp) {
  const auto q = placedAt(X_WT);
  return context_->describeCollision(q.data(), &grasp);
}

}  // namespace b4p
