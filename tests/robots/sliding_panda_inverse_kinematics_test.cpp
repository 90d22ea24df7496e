// SPDX-License-Identifier: BSD-3-Clause
#include "robots/sliding_panda_inverse_kinematics.h"

#include <gtest/gtest.h>

#include "robots/kinematic_chain.h"
#include "robots/shipped_robot.h"

// Promises beyond those of every inverse kinematics: nearly all poses are solved, with bases on all sides of
// them; the base stays where the seed has it when the arm reaches from there; only a Panda that slides is
// taken for one.

namespace b4p {
namespace {

TEST(SlidingPandaInverseKinematics, SolvesNearlyAllPosesWithBasesAllAboutThem) {
  for (const auto& robot : {shippedRobot("mobile_panda", unevenPose()), pandaOnCarriage()}) {
    const auto ik = makeSlidingPandaInverseKinematics(robot);
    ASSERT_NE(ik, nullptr);
    KinematicChain kdl(robot);
    std::mt19937_64 random(61);
    Eigen::VectorXd q;
    int found = 0, left = 0, ahead = 0;
    constexpr int kPoses = 2000;
    for (int i = 0; i < kPoses; ++i) {
      Eigen::VectorXd middle = randomConfiguration(*robot, random);
      middle.head<2>() *= 0.3;
      const Eigen::Isometry3d X_WT = robot->tcpPose(middle.data());
      if (!ik->solve(X_WT, random, 64, q)) continue;
      ++found;
      EXPECT_TRUE(robot->withinLimits(q.data()));
      EXPECT_TRUE(kdl.tcpPose(q.data()).matrix().isApprox(X_WT.matrix(), 1e-6));
      left += q[0] > middle[0] ? 1 : 0;
      ahead += q[1] > middle[1] ? 1 : 0;
    }
    EXPECT_GT(found, kPoses * 99 / 100);
    EXPECT_NEAR(left, kPoses / 2, kPoses / 8);
    EXPECT_NEAR(ahead, kPoses / 2, kPoses / 8);
  }
}

TEST(SlidingPandaInverseKinematics, KeepsTheSeedsBaseFromWhereTheArmReaches) {
  const auto robot = shippedRobot("mobile_panda", unevenPose());
  const auto ik = makeSlidingPandaInverseKinematics(robot);
  std::mt19937_64 random(62);
  Eigen::VectorXd found;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::VectorXd q = randomConfiguration(*robot, random);
    Eigen::VectorXd seed = randomConfiguration(*robot, random);
    seed.head<2>() = q.head<2>();
    seed[8] = q[8];
    ASSERT_TRUE(ik->solveFrom(robot->tcpPose(q.data()), seed, found)) << q.transpose();
    EXPECT_LT((found.head<2>() - q.head<2>()).norm(), 1e-12);
  }
}

TEST(SlidingPandaInverseKinematics, RefusesOtherRobots) {
  EXPECT_EQ(makeSlidingPandaInverseKinematics(shippedRobot("panda")), nullptr);
  EXPECT_EQ(makeSlidingPandaInverseKinematics(shippedRobot("planar_gripper")), nullptr);
  const auto mobile = shippedRobot("mobile_panda");
  const auto taken = [&](const std::string& changed, const Eigen::Vector3d& axis, double shift) {
    RobotModel model = mobile->model();
    Joint& joint = model.joints[static_cast<std::size_t>(model.jointIndex(changed))];
    if (!axis.isZero()) joint.axis = axis.normalized();
    joint.X_PJ.translation().x() += shift;
    const auto robot =
        std::make_shared<const Manipulator>(model, mobile->description(), unevenPose(), "changed");
    return makeSlidingPandaInverseKinematics(robot) != nullptr;
  };
  const Eigen::Vector3d same = Eigen::Vector3d::Zero();
  EXPECT_TRUE(taken("base_x", same, 0.1)) << "where the base stands does not matter";
  EXPECT_FALSE(taken("base_x", {1, 0.01, 0}, 0.0)) << "not at a right angle";
  EXPECT_FALSE(taken("panda_joint4", same, 1e-3)) << "no Panda";
}

}  // namespace
}  // namespace b4p
