// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "robots/shipped_robot.h"

// Promises: both arms of the YuMi have the published kinematics, multiplied out here by hand; limits, hands
// and the outline of the body are the published ones; and the arm that does not move rests where its robot
// file says.

namespace b4p {
namespace {

constexpr double kPi = 3.14159265358979323846;

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d turn(int axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Matrix3d R;
  if (axis == 0) R << 1, 0, 0, 0, c, -s, 0, s, c;
  if (axis == 1) R << c, 0, s, 0, 1, 0, -s, 0, c;
  if (axis == 2) R << c, -s, 0, s, c, 0, 0, 0, 1;
  return R;
}

Isometry3d placed(const Vector3d& xyz, double roll, double pitch, double yaw) {
  Isometry3d X = Isometry3d::Identity();
  X.linear() = turn(2, yaw) * turn(1, pitch) * turn(0, roll);
  X.translation() = xyz;
  return X;
}

/// Of the gripper's base in the body, from the published origins of joints 1, 2, 7, 3, 4, 5, 6.
Isometry3d gripperBase(const std::string& side, const Eigen::VectorXd& q) {
  const double h = kPi / 2;
  const std::array<Isometry3d, 7> origins{
      side == "left" ? placed({0.05355, 0.0725, 0.41492}, 0.9781, -0.5716, 2.3180)
                     : placed({0.05355, -0.0725, 0.41492}, -0.9795, -0.5682, -2.3155),
      placed({0.03, 0, 0.1}, h, 0, 0),
      placed({-0.03, 0.17283, 0}, -h, 0, 0),
      placed({-0.04188, 0, 0.07873}, h, -h, 0),
      placed({0.0405, 0.16461, 0}, -h, 0, 0),
      placed({-0.027, 0, 0.10039}, h, 0, 0),
      placed({0.027, 0.029, 0}, -h, 0, 0)};
  Isometry3d X = Isometry3d::Identity();
  for (int i = 0; i < 7; ++i)
    X = X * origins[static_cast<std::size_t>(i)] * placed(Vector3d::Zero(), 0, 0, q[i]);
  return X * placed({0, 0, 0.007}, 0, 0, kPi);
}

Eigen::VectorXd start(const std::string& side) {
  Eigen::VectorXd q = Eigen::VectorXd::Zero(7);
  q.head<2>() = side == "left" ? Eigen::Vector2d(-0.93, -1.55) : Eigen::Vector2d(0.69, -1.95);
  return q;
}

class Yumi : public testing::TestWithParam<const char*> {
 protected:
  std::string side() const { return GetParam(); }
  std::string named(const std::string& end) const { return "yumi_" + side() + "_" + end; }
  std::size_t link(const std::string& name) const {
    return static_cast<std::size_t>(robot_->model().linkIndex(name));
  }

  std::shared_ptr<const Manipulator> robot_ = shippedRobot(std::string("yumi_") + GetParam());
};

TEST_P(Yumi, IsTheChainMultipliedByHand) {
  std::mt19937_64 random(5);
  std::vector<Isometry3d> X_WL;
  for (int i = 0; i < 200; ++i) {
    const Eigen::VectorXd q = randomConfiguration(*robot_, random);
    const Isometry3d expected = gripperBase(side(), q);
    robot_->linkPoses(q.data(), 0.0, X_WL);
    EXPECT_TRUE(X_WL[link(named("gripper"))].isApprox(expected, 1e-12));
    const Isometry3d X_WT = robot_->tcpPose(q.data());
    EXPECT_TRUE(X_WT.linear().col(2).isApprox(expected.linear().col(2), 1e-12)) << "it approaches along z";
    EXPECT_NEAR(std::abs(X_WT.linear().col(1).dot(expected.linear().col(0))), 1.0, 1e-12)
        << "the gripper closes along its x";
    EXPECT_TRUE(X_WT.translation().isApprox(expected * Vector3d(0, 0, 0.127), 1e-12));
  }
}

TEST_P(Yumi, HasThePublishedLimitsInTheOrderOfTheChain) {
  Eigen::VectorXd lower(7), upper(7), velocity(7);
  lower << -2.9409, -2.5045, -2.9409, -2.1555, -5.0615, -1.5359, -3.9968;
  upper << 2.9409, 0.7592, 2.9409, 1.3963, 5.0615, 2.4086, 3.9968;
  velocity << 3.14, 3.14, 3.14, 3.14, 6.98, 6.98, 6.98;
  ASSERT_EQ(robot_->dof(), 7);
  EXPECT_EQ(robot_->lower(), lower);
  EXPECT_EQ(robot_->upper(), upper);
  const char* numbers = "1273456";
  for (int i = 0; i < 7; ++i) {
    const auto joint = static_cast<std::size_t>(robot_->plannedJoints()[static_cast<std::size_t>(i)]);
    EXPECT_EQ(robot_->model().joints[joint].max_velocity, velocity[i]);
    EXPECT_EQ(robot_->model().joints[joint].name, named(std::string("joint") + numbers[i]));
  }
}

TEST_P(Yumi, PadsStandApartByTheOpeningAroundTheTcp) {
  const Eigen::VectorXd q = start(side());
  std::vector<Isometry3d> X_WL;
  for (const double opening : {0.0, 0.02, 0.05}) {
    robot_->linkPoses(q.data(), opening, X_WL);
    double sides = 0.0;
    for (const int finger : robot_->fingerLinks()) {
      const PlacedShape& box = robot_->model().links[static_cast<std::size_t>(finger)].shapes.front();
      const Isometry3d X_TS =
          robot_->tcpPose(q.data()).inverse() * X_WL[static_cast<std::size_t>(finger)] * box.X_BS;
      const Vector3d half = std::get<Box>(box.shape).size / 2.0, middle = X_TS.translation();
      const Vector3d reach = X_TS.linear().cwiseAbs() * half;
      EXPECT_NEAR(std::abs(middle.y()) - reach.y(), opening / 2.0, 1e-12);
      EXPECT_NEAR(middle.z() + reach.z(), 0.0837 + 0.052 - 0.127, 1e-12) << "the tip";
      EXPECT_NEAR(middle.x(), 0.0, 1e-3) << "pads face each other";
      sides += std::copysign(1.0, middle.y());
    }
    EXPECT_EQ(sides, 0.0) << "one finger on either side";
  }
}

TEST_P(Yumi, BodyFillsThePublishedOutlineButIsHollow) {
  const Link& body = robot_->model().links[link("yumi_body")];
  Eigen::AlignedBox3d outline;
  double volume = 0.0;
  for (const PlacedShape& placed : body.shapes) {
    const Vector3d size = std::get<Box>(placed.shape).size, middle = placed.X_BS.translation();
    EXPECT_TRUE(placed.X_BS.linear().isIdentity());
    outline.extend(Vector3d(middle - size / 2.0));
    outline.extend(Vector3d(middle + size / 2.0));
    volume += size.prod();
  }
  EXPECT_TRUE(outline.min().isApprox(Vector3d(-0.361, -0.2, -0.1), 1e-12)) << outline.min().transpose();
  EXPECT_TRUE(outline.max().isApprox(Vector3d(0.135, 0.2, 0.471), 1e-12)) << outline.max().transpose();
  EXPECT_LT(volume, 0.6 * outline.volume());
}

TEST_P(Yumi, LinksAreThePublishedCylinders) {
  const double radii[] = {0.068, 0.070, 0.054, 0.059, 0.046, 0.060, 0.032};
  const double heights[] = {0.196, 0.248, 0.169, 0.237, 0.166, 0.094, 0.024};
  const Vector3d middles[] = {{0.020, -0.019, 0.057},
                              {-0.016, 0.067, -0.014},
                              {-0.023, -0.021, 0.052},
                              {0.021, 0.063, -0.014},
                              {-0.010, -0.027, 0.054},
                              {0.022, -0.014, -0.020},
                              {0, 0, 0}};
  const Vector3d axes[] = {{-0.48, 0.35, -0.81},
                           {-0.29, 0.91, 0.31},
                           {0.48, 0.35, -0.81},
                           {0.29, 0.91, 0.31},
                           {0.18, 0.56, -0.81},
                           {0, 0, 1},
                           {0, 0, 1}};
  for (int i = 0; i < 7; ++i) {
    const Link& body = robot_->model().links[link(named("link" + std::to_string(i + 1)))];
    ASSERT_EQ(body.shapes.size(), 1u);
    const auto& cylinder = std::get<Cylinder>(body.shapes.front().shape);
    EXPECT_DOUBLE_EQ(cylinder.radius, radii[i]) << body.name;
    EXPECT_DOUBLE_EQ(cylinder.length, heights[i]) << body.name;
    EXPECT_TRUE(body.shapes.front().X_BS.translation().isApprox(middles[i], 1e-9)) << body.name;
    EXPECT_NEAR(body.shapes.front().X_BS.linear().col(2).dot(axes[i].normalized()), 1.0, 1e-9) << body.name;
  }
}

TEST_P(Yumi, OtherArmRestsAtItsStart) {
  const std::string other = side() == "left" ? "right" : "left";
  const Eigen::VectorXd q = Eigen::VectorXd::Constant(7, 0.3);
  std::vector<Isometry3d> X_WL;
  robot_->linkPoses(q.data(), 0.0, X_WL);
  const Isometry3d gripper = gripperBase(other, start(other));
  EXPECT_TRUE(X_WL[link("yumi_" + other + "_gripper")].isApprox(gripper, 1e-12));
  for (int finger = 1; finger <= 2; ++finger) {
    const Vector3d p =
        gripper.inverse() * X_WL[link("yumi_" + other + "_finger" + std::to_string(finger))].translation();
    EXPECT_NEAR(std::abs(p.x()), 0.02, 1e-12);
  }
}

TEST(YumiArms, ReachTheCheckValues) {
  // From the published chain, worked out to five digits.
  const auto at = [](const std::string& side, const Eigen::VectorXd& q) {
    return Vector3d(shippedRobot("yumi_" + side)->tcpPose(q.data()).translation());
  };
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(7);
  EXPECT_LT((at("left", zero) - Vector3d(0.64119, -0.08332, 0.34492)).norm(), 1e-5);
  EXPECT_LT((at("left", start("left")) - Vector3d(0.46632, 0.57167, 0.62608)).norm(), 1e-5);
  EXPECT_LT((at("right", zero) - Vector3d(0.64101, 0.08458, 0.34628)).norm(), 1e-5);
  EXPECT_LT((at("right", start("right")) - Vector3d(0.24370, -0.67972, 0.61450)).norm(), 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Arms, Yumi, testing::Values("left", "right"),
                         [](const auto& instance) { return std::string(instance.param); });

}  // namespace
}  // namespace b4p
