// SPDX-License-Identifier: BSD-3-Clause
#include "robots/manipulator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robots/input_error.h"
#include "robots/joint_motion.h"
#include "robots/number_text.h"

namespace b4p {
namespace {

// Where a joint's value comes from, other than an index into q.
constexpr int kConstant = -1;
constexpr int kFinger = -2;

template <typename Item>
const Item& at(const std::vector<Item>& items, int index) {
  return items[static_cast<std::size_t>(index)];
}

/// Looks names up in a model, and complains about those that are not there.
class NameResolver {
 public:
  NameResolver(const RobotModel& model, std::string source) : model_(model), source_(std::move(source)) {}

  int link(const std::string& key, const std::string& name) const {
    const int index = model_.linkIndex(name);
    if (index < 0) fail(key, "robot '" + model_.name + "' has no link '" + name + "'");
    return index;
  }

  std::vector<int> links(const std::string& key, const std::vector<std::string>& link_names) const {
    std::vector<int> indices;
    for (const std::string& name : link_names) {
      indices.push_back(link(key, name));
      if (std::count(indices.begin(), indices.end(), indices.back()) > 1)
        fail(key, "link '" + name + "' is listed twice");
    }
    return indices;
  }

  std::vector<int> movingJoints(const std::string& key, const std::vector<std::string>& joint_names) const {
    std::vector<int> indices;
    for (const std::string& name : joint_names) {
      indices.push_back(model_.jointIndex(name));
      if (indices.back() < 0) fail(key, "robot '" + model_.name + "' has no joint '" + name + "'");
      if (at(model_.joints, indices.back()).type == JointType::kFixed)
        fail(key, "joint '" + name + "' is fixed");
      if (std::count(indices.begin(), indices.end(), indices.back()) > 1)
        fail(key, "joint '" + name + "' is listed twice");
    }
    return indices;
  }

  [[noreturn]] void fail(const std::string& key, const std::string& problem) const {
    throw InputError(source_, key, problem);
  }

 private:
  const RobotModel& model_;
  std::string source_;
};

/// Joints from the root to a link, nearest to the link first.
std::vector<int> jointsAbove(const RobotModel& model, int link) {
  std::vector<int> path;
  for (int joint = at(model.links, link).parent_joint; joint >= 0;) {
    path.push_back(joint);
    joint = at(model.links, at(model.joints, joint).parent_link).parent_joint;
  }
  return path;
}

/// All moving joints up to the TCP, and no others, have to be planned: q then decides where the TCP is.
void checkPlannedJoints(const RobotModel& model, const std::vector<int>& sources, int tcp_link,
                        const NameResolver& names) {
  const std::vector<int> path = jointsAbove(model, tcp_link);
  const std::string& tcp = at(model.links, tcp_link).name;
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const bool on_path = std::find(path.begin(), path.end(), static_cast<int>(j)) != path.end();
    const bool planned = sources[j] >= 0;
    const Joint& joint = model.joints[j];
    if (planned && !on_path)
      names.fail("joints", "joint '" + joint.name + "' does not lie between the root and '" + tcp + "'");
    if (on_path && !planned && joint.type != JointType::kFixed)
      names.fail("joints", "joint '" + joint.name + "' moves '" + tcp + "' but is not listed");
  }
}

/// A joint that repeats another is understood only if both are fingers, which open together anyway.
void checkMimics(const RobotModel& model, const std::vector<int>& sources, const NameResolver& names) {
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    if (joint.mimicked_joint.empty()) continue;
    const int other = model.jointIndex(joint.mimicked_joint);
    if (sources[j] != kFinger || other < 0 || at(sources, other) != kFinger)
      names.fail("joint '" + joint.name + "'",
                 "mimics '" + joint.mimicked_joint + "', which is supported only between two finger joints");
  }
}

/// Rest values by joint: those described, else the value inside the limits that is nearest to zero.
std::vector<double> restValues(const RobotModel& model, const std::map<std::string, double>& described,
                               const std::vector<int>& sources, const NameResolver& names) {
  std::vector<double> values;
  for (const Joint& joint : model.joints) values.push_back(std::clamp(0.0, joint.lower, joint.upper));
  for (const auto& [name, value] : described) {
    const int index = names.movingJoints("rest", {name}).front();
    const Joint& joint = at(model.joints, index);
    if (at(sources, index) != kConstant)
      names.fail("rest", "joint '" + name + "' is planned or a finger, and does not rest");
    if (!(value >= joint.lower && value <= joint.upper))
      names.fail("rest", "joint '" + name + "' at " + numberText(value) + " is outside its limits, " +
                             numberText(joint.lower) + " to " + numberText(joint.upper));
    values[static_cast<std::size_t>(index)] = value;
  }
  return values;
}

/// Half the widest opening has to be within each finger's travel, and so has none.
void checkOpening(const RobotModel& model, const std::vector<int>& fingers, double max_opening_m,
                  const NameResolver& names) {
  constexpr double kTolerance_m = 1e-9;
  if (!std::isfinite(max_opening_m) || max_opening_m < 0.0)
    names.fail("max_opening_m", "has to be at least zero and finite, not " + numberText(max_opening_m));
  for (const int finger : fingers) {
    const Joint& joint = at(model.joints, finger);
    if (joint.type != JointType::kPrismatic)
      names.fail("finger_joints", "joint '" + joint.name + "' is not prismatic");
    if (joint.lower > kTolerance_m || joint.upper < max_opening_m / 2.0 - kTolerance_m)
      names.fail("max_opening_m", "half of " + numberText(max_opening_m) + " m is more than joint '" +
                                      joint.name + "' can do, from " + numberText(joint.lower) + " to " +
                                      numberText(joint.upper) + " m");
  }
}

}  // namespace

Manipulator::Manipulator(RobotModel model, ManipulatorDescription description, const Eigen::Isometry3d& X_WB,
                         const std::string& source)
    : model_(std::move(model)), description_(std::move(description)), X_WB_(X_WB) {
  const NameResolver names(model_, source);
  if (!X_WB_.matrix().allFinite()) names.fail("robot_base", "the pose is not finite");
  planned_ = names.movingJoints("joints", description_.joints);
  if (planned_.empty()) names.fail("joints", "no joint is listed");
  tcp_link_ = names.link("tcp_link", description_.tcp_link);
  finger_links_ = names.links("finger_links", description_.finger_links);
  for (const auto& [first, second] : description_.skip_self_collision)
    if (names.link("skip_self_collision", first) == names.link("skip_self_collision", second))
      names.fail("skip_self_collision", "link '" + first + "' is paired with itself");

  joint_source_.assign(model_.joints.size(), kConstant);
  lower_.resize(dof());
  upper_.resize(dof());
  for (int i = 0; i < dof(); ++i) {
    const Joint& joint = at(model_.joints, at(planned_, i));
    joint_source_[static_cast<std::size_t>(at(planned_, i))] = i;
    lower_[i] = joint.lower;
    upper_[i] = joint.upper;
  }
  const std::vector<int> fingers = names.movingJoints("finger_joints", description_.finger_joints);
  for (const int finger : fingers) {
    int& value_source = joint_source_[static_cast<std::size_t>(finger)];
    if (value_source >= 0)
      names.fail("finger_joints",
                 "joint '" + at(model_.joints, finger).name + "' is also one of the planned joints");
    value_source = kFinger;
  }
  rest_ = restValues(model_, description_.rest, joint_source_, names);

  checkPlannedJoints(model_, joint_source_, tcp_link_, names);
  checkMimics(model_, joint_source_, names);
  checkOpening(model_, fingers, description_.max_opening_m, names);
}

void Manipulator::linkPoses(const double* q, double opening_m, std::vector<Eigen::Isometry3d>& X_WL) const {
  X_WL.resize(model_.links.size());
  X_WL[0] = X_WB_;
  for (std::size_t j = 0; j < model_.joints.size(); ++j) {
    const Joint& joint = model_.joints[j];
    const int value_source = joint_source_[j];
    const double value = value_source >= 0         ? q[value_source]
                         : value_source == kFinger ? opening_m / 2.0
                                                   : rest_[j];
    X_WL[static_cast<std::size_t>(joint.child_link)] =
        at(X_WL, joint.parent_link) * childInParent(joint, value);
  }
}

Eigen::Isometry3d Manipulator::tcpPose(const double* q) const {
  Eigen::Isometry3d X_LT = Eigen::Isometry3d::Identity();
  for (int link = tcp_link_; at(model_.links, link).parent_joint >= 0;) {
    const int j = at(model_.links, link).parent_joint;
    const Joint& joint = at(model_.joints, j);
    // Every moving joint on this path is planned, the others are fixed.
    const int value_source = at(joint_source_, j);
    X_LT = childInParent(joint, value_source >= 0 ? q[value_source] : 0.0) * X_LT;
    link = joint.parent_link;
  }
  return X_WB_ * X_LT;
}

bool Manipulator::withinLimits(const double* q) const {
  for (int i = 0; i < dof(); ++i)
    if (!(q[i] >= lower_[i] && q[i] <= upper_[i])) return false;  // false for NaN too
  return true;
}

}  // namespace b4p
