// SPDX-License-Identifier: BSD-3-Clause
#include "robots/aligned_chain.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "robots/kinematic_chain.h"
#include "robots/shipped_robot.h"

// Promise: poses and Jacobians are those of KDL, whatever the axes, the kinds of joints and the order of q.

namespace b4p {
namespace {

void expectSameAsKdl(const std::shared_ptr<const Manipulator>& robot) {
  const AlignedChain chain(*robot);
  KinematicChain kdl(robot);
  std::mt19937_64 random(31);
  Eigen::MatrixXd jacobian(6, robot->dof());
  for (int i = 0; i < 200; ++i) {
    const Eigen::VectorXd q = randomConfiguration(*robot, random);
    const Eigen::Isometry3d X_WT = chain.tcpPose(q.data(), jacobian), expected = kdl.tcpPose(q.data());
    EXPECT_TRUE(X_WT.matrix().isApprox(expected.matrix(), 1e-12));
    EXPECT_TRUE(chain.frames(q.data()).back().matrix().isApprox(expected.matrix(), 1e-12));
    EXPECT_TRUE(jacobian.isApprox(kdl.jacobian(q.data()), 1e-12));
  }
}

TEST(AlignedChain, AgreesWithKdlOnShippedRobots) {
  expectSameAsKdl(shippedRobot("panda", unevenPose()));
  expectSameAsKdl(shippedRobot("planar_gripper", unevenPose()));
  expectSameAsKdl(shippedRobot("mobile_panda", unevenPose()));
  expectSameAsKdl(shippedRobot("yumi_left", unevenPose()));
  expectSameAsKdl(shippedRobot("yumi_right", unevenPose()));
}

TEST(AlignedChain, AgreesWithKdlOnAnyAxesAndOrder) {
  const auto carriage = pandaOnCarriage();
  RobotModel model = carriage->model();
  std::mt19937_64 random(32);
  std::uniform_real_distribution<> coordinate(-1.0, 1.0);
  for (Joint& joint : model.joints)
    joint.axis = Eigen::Vector3d(coordinate(random), coordinate(random), coordinate(random)).normalized();
  model.joints[2].axis = -Eigen::Vector3d::UnitZ();
  ManipulatorDescription description = carriage->description();
  std::reverse(description.joints.begin(), description.joints.end());
  expectSameAsKdl(std::make_shared<const Manipulator>(model, description, unevenPose(), "test"));
}

}  // namespace
}  // namespace b4p
