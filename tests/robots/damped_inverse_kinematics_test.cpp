// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "robots/inverse_kinematics.h"
#include "robots/kinematic_chain.h"
#include "robots/shipped_robot.h"

// Promises beyond those of every inverse kinematics: none of many answers is wrong by KDL's kinematics,
// robots with more joints than seven are solved, and half a turn is no obstacle.

namespace b4p {
namespace {

TEST(DampedInverseKinematics, NoneOfManyAnswersIsWrong) {
  constexpr int kPoses = 100000, kAttempts = 8;
  const auto panda = shippedRobot("panda", unevenPose());
  const IkTolerance tolerance;
  const auto ik = makeDampedInverseKinematics(panda, tolerance);
  KinematicChain kdl(panda);
  std::mt19937_64 random(41);
  Eigen::VectorXd q;
  int found = 0, outside = 0, off = 0;
  for (int i = 0; i < kPoses; ++i) {
    const Eigen::Isometry3d X_WT = panda->tcpPose(randomConfiguration(*panda, random).data());
    if (!ik->solve(X_WT, random, kAttempts, q)) continue;
    ++found;
    if (!panda->withinLimits(q.data())) ++outside;
    const Eigen::Isometry3d reached = kdl.tcpPose(q.data());
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(reached.linear().transpose() * X_WT.linear()));
    if ((reached.translation() - X_WT.translation()).norm() > tolerance.position_m ||
        turn.angle() > tolerance.angle_rad)
      ++off;
  }
  EXPECT_EQ(outside, 0);
  EXPECT_EQ(off, 0);
  EXPECT_GT(found, kPoses * 9 / 10);
}

TEST(DampedInverseKinematics, SolvesRobotsWithMoreJoints) {
  const auto carriage = pandaOnCarriage();
  const auto ik = makeDampedInverseKinematics(carriage);
  std::mt19937_64 random(42);
  Eigen::VectorXd q;
  int found = 0;
  for (int i = 0; i < 300; ++i)
    if (ik->solve(carriage->tcpPose(randomConfiguration(*carriage, random).data()), random, 20, q)) ++found;
  EXPECT_GE(found, 297);
}

TEST(DampedInverseKinematics, HalfATurnIsNoObstacle) {
  const auto planar = shippedRobot("planar_gripper");
  const auto ik = makeDampedInverseKinematics(planar);
  const Eigen::Vector3d seed(2.0, 3.0, 0.0), target(2.0, 3.0, 3.14159265358979323846);
  Eigen::VectorXd q;
  ASSERT_TRUE(ik->solveFrom(planar->tcpPose(target.data()), seed, q));
  EXPECT_NEAR(std::abs(q[2]), target[2], 1e-3);
}

}  // namespace
}  // namespace b4p
