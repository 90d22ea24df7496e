// SPDX-License-Identifier: BSD-3-Clause
#include "robots/kinematic_chain.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "robots/shipped_robot.h"

// Promises: KDL and the Manipulator agree on where everything is, the Jacobian is the derivative of the pose,
// values that are not finite are refused, and chains in several threads do not disturb each other.

namespace b4p {
namespace {

class KinematicChainOf : public testing::TestWithParam<const char*> {
 protected:
  std::shared_ptr<const Manipulator> robot_ = shippedRobot(GetParam(), unevenPose());
  KinematicChain chain_{robot_};
  std::mt19937_64 random_{11};
};

TEST_P(KinematicChainOf, AgreesWithTheManipulator) {
  std::vector<Eigen::Isometry3d> X_WL;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::VectorXd q = randomConfiguration(*robot_, random_);
    const Eigen::Isometry3d by_kdl = chain_.tcpPose(q.data());
    robot_->linkPoses(q.data(), 0.0, X_WL);
    EXPECT_TRUE(by_kdl.matrix().isApprox(X_WL[static_cast<std::size_t>(robot_->tcpLink())].matrix(), 1e-12));
    EXPECT_TRUE(by_kdl.matrix().isApprox(robot_->tcpPose(q.data()).matrix(), 1e-12));
  }
}

TEST_P(KinematicChainOf, JacobianEqualsFiniteDifferences) {
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 50; ++i) {
    const Eigen::VectorXd q = randomConfiguration(*robot_, random_);
    const Eigen::MatrixXd jacobian = chain_.jacobian(q.data());
    ASSERT_EQ(jacobian.rows(), 6);
    ASSERT_EQ(jacobian.cols(), robot_->dof());
    for (int j = 0; j < robot_->dof(); ++j) {
      Eigen::VectorXd ahead = q, behind = q;
      ahead[j] += kStep;
      behind[j] -= kStep;
      const Eigen::Isometry3d a = robot_->tcpPose(ahead.data()), b = robot_->tcpPose(behind.data());
      const Eigen::AngleAxisd turn(Eigen::Matrix3d(a.linear() * b.linear().transpose()));
      Eigen::Matrix<double, 6, 1> difference;
      difference << a.translation() - b.translation(), turn.angle() * turn.axis();
      EXPECT_LT((difference / (2.0 * kStep) - jacobian.col(j)).norm(), 1e-7);
    }
  }
}

TEST_P(KinematicChainOf, RefusesNonFiniteValues) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Eigen::VectorXd q = Eigen::VectorXd::Zero(robot_->dof());
    q[robot_->dof() - 1] = bad;
    EXPECT_THROW(chain_.tcpPose(q.data()), std::invalid_argument);
    EXPECT_THROW(chain_.jacobian(q.data()), std::invalid_argument);
  }
}

TEST_P(KinematicChainOf, ChainsOfSeveralThreadsDoNotDisturbEachOther) {
  std::vector<Eigen::VectorXd> configurations;
  for (int i = 0; i < 20000; ++i) configurations.push_back(randomConfiguration(*robot_, random_));
  std::vector<std::thread> threads;
  std::vector<int> wrong(4, 0);
  for (std::size_t t = 0; t < wrong.size(); ++t)
    threads.emplace_back([&, t] {
      KinematicChain own(robot_);
      for (const auto& q : configurations)
        if (!own.tcpPose(q.data()).matrix().isApprox(robot_->tcpPose(q.data()).matrix(), 1e-12)) ++wrong[t];
    });
  for (auto& thread : threads) thread.join();
  for (const int count : wrong) EXPECT_EQ(count, 0);
}

INSTANTIATE_TEST_SUITE_P(ShippedRobots, KinematicChainOf,
                         testing::Values("panda", "planar_gripper", "mobile_panda", "yumi_left",
                                         "yumi_right"),
                         [](const auto& instance) { return std::string(instance.param); });

// The order of q is the description's, which need not be the order along the arm.
TEST(KinematicChain, FollowsTheOrderOfTheDescription) {
  const auto panda = shippedRobot("panda");
  ManipulatorDescription description = panda->description();
  std::reverse(description.joints.begin(), description.joints.end());
  const auto turned = std::make_shared<const Manipulator>(panda->model(), description, panda->X_WB(), "test");
  KinematicChain chain(panda), turned_chain(turned);
  std::mt19937_64 random(5);
  const Eigen::VectorXd q = randomConfiguration(*panda, random);
  const Eigen::VectorXd q_turned = q.reverse();
  EXPECT_TRUE(turned_chain.tcpPose(q_turned.data()).isApprox(chain.tcpPose(q.data()), 1e-12));
  EXPECT_TRUE(turned->tcpPose(q_turned.data()).isApprox(chain.tcpPose(q.data()), 1e-12));
  EXPECT_TRUE(
      turned_chain.jacobian(q_turned.data()).rowwise().reverse().isApprox(chain.jacobian(q.data()), 1e-12));
}

}  // namespace
}  // namespace b4p
