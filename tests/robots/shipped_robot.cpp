// SPDX-License-Identifier: BSD-3-Clause
#include "robots/shipped_robot.h"

#include <yaml-cpp/yaml.h>

namespace b4p {

ManipulatorDescription shippedDescription(const std::string& name) {
  const YAML::Node file = YAML::LoadFile(std::string(B4P_ROBOTS_FOLDER) + "/" + name + ".yaml");
  ManipulatorDescription description;
  description.joints = file["joints"].as<std::vector<std::string>>();
  description.tcp_link = file["tcp_link"].as<std::string>();
  description.finger_joints = file["gripper"]["finger_joints"].as<std::vector<std::string>>();
  description.finger_links = file["gripper"]["finger_links"].as<std::vector<std::string>>();
  description.max_opening_m = file["gripper"]["max_opening_m"].as<double>();
  description.skip_self_collision =
      file["skip_self_collision"].as<std::vector<std::pair<std::string, std::string>>>();
  if (file["rest"]) description.rest = file["rest"].as<std::map<std::string, double>>();
  return description;
}

std::shared_ptr<const Manipulator> shippedRobot(const std::string& name, const Eigen::Isometry3d& X_WB) {
  const YAML::Node file = YAML::LoadFile(std::string(B4P_ROBOTS_FOLDER) + "/" + name + ".yaml");
  const std::string urdf = std::string(B4P_ROBOTS_FOLDER) + "/" + file["urdf"].as<std::string>();
  return std::make_shared<const Manipulator>(loadUrdf(urdf), shippedDescription(name), X_WB, name + ".yaml");
}

Eigen::VectorXd randomConfiguration(const Manipulator& robot, std::mt19937_64& random) {
  Eigen::VectorXd q(robot.dof());
  for (int i = 0; i < robot.dof(); ++i)
    q[i] = std::uniform_real_distribution<double>(robot.lower()[i], robot.upper()[i])(random);
  return q;
}

std::shared_ptr<const Manipulator> pandaOnCarriage() {
  const auto panda = shippedRobot("panda");
  RobotModel model;
  model.name = "panda_on_carriage";
  ManipulatorDescription description = panda->description();
  description.joints.insert(description.joints.begin(), {"slide_x", "slide_y"});
  for (int i = 0; i < 2; ++i) {
    Joint slide;
    slide.name = description.joints[static_cast<std::size_t>(i)];
    slide.type = JointType::kPrismatic;
    slide.axis = Eigen::Vector3d::Unit(i);
    slide.lower = -1.0;
    slide.upper = 1.0;
    slide.parent_link = i;
    slide.child_link = i + 1;
    model.joints.push_back(slide);
    model.links.push_back({"carriage" + std::to_string(i), {}, i - 1});
  }
  for (Link link : panda->model().links) {
    link.parent_joint += 2;
    model.links.push_back(link);
  }
  model.links[2].parent_joint = 1;
  for (Joint joint : panda->model().joints) {
    joint.parent_link += 2;
    joint.child_link += 2;
    model.joints.push_back(joint);
  }
  return std::make_shared<const Manipulator>(model, description, unevenPose(), "carriage");
}

Eigen::Isometry3d unevenPose() {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translate(Eigen::Vector3d(0.4, -0.7, 0.2))
      .rotate(Eigen::AngleAxisd(0.6, Eigen::Vector3d(1, 2, -1).normalized()));
  return X;
}

}  // namespace b4p
