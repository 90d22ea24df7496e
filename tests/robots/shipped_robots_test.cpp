// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "robots/shipped_robot.h"

// Promises: the robots that ship with b4p load, have the published kinematics, and carry the geometry
// described.

namespace b4p {
namespace {

constexpr double kPi = 3.14159265358979323846;

const Link& linkNamed(const Manipulator& robot, const std::string& name) {
  return robot.model().links.at(static_cast<std::size_t>(robot.model().linkIndex(name)));
}

TEST(Panda, ReachesThePublishedCheckValue) {
  const auto panda = shippedRobot("panda");
  const double q[] = {0, -0.785, 0, -2.356, 0, 1.571, 0.785};
  const Eigen::Isometry3d X_WT = panda->tcpPose(q);
  EXPECT_NEAR(X_WT.translation().x(), 0.30702, 1e-5);
  EXPECT_NEAR(X_WT.translation().y(), 0.0, 1e-5);
  EXPECT_NEAR(X_WT.translation().z(), 0.48687, 1e-5);
  // The hand points down and closes along y.
  EXPECT_NEAR(X_WT.linear()(2, 2), -1.0, 1e-3);
  EXPECT_NEAR(std::abs(X_WT.linear()(1, 1)), 1.0, 1e-3);
}

TEST(Panda, HasThePublishedLimits) {
  const auto panda = shippedRobot("panda");
  Eigen::VectorXd lower(7), upper(7), velocity(7);
  lower << -2.8973, -1.7628, -2.8973, -3.0718, -2.8973, -0.0175, -2.8973;
  upper << 2.8973, 1.7628, 2.8973, -0.0698, 2.8973, 3.7525, 2.8973;
  velocity << 2.175, 2.175, 2.175, 2.175, 2.61, 2.61, 2.61;
  ASSERT_EQ(panda->dof(), 7);
  EXPECT_EQ(panda->lower(), lower);
  EXPECT_EQ(panda->upper(), upper);
  for (int i = 0; i < 7; ++i)
    EXPECT_EQ(panda->model()
                  .joints[static_cast<std::size_t>(panda->plannedJoints()[static_cast<std::size_t>(i)])]
                  .max_velocity,
              velocity[i]);
}

TEST(Panda, ArmLinksAreOneCapsuleEach) {
  const auto panda = shippedRobot("panda");
  const double radii[] = {0.108, 0.076, 0.077, 0.070, 0.070, 0.069, 0.076, 0.050};
  for (int i = 0; i < 8; ++i) {
    const Link& link = linkNamed(*panda, "panda_link" + std::to_string(i));
    ASSERT_EQ(link.shapes.size(), 1u) << link.name;
    const auto* capsule = std::get_if<Capsule>(&link.shapes.front().shape);
    ASSERT_NE(capsule, nullptr) << link.name;
    EXPECT_DOUBLE_EQ(capsule->radius, radii[i]) << link.name;
  }
}

TEST(Panda, CapsuleEndsLieWhereTheyShould) {
  const auto panda = shippedRobot("panda");
  const PlacedShape& placed = linkNamed(*panda, "panda_link7").shapes.front();
  const double half = std::get<Capsule>(placed.shape).length / 2.0;
  const Eigen::Vector3d a(0.033, 0.034, 0.079), b(-0.005, -0.005, 0.074);
  const Eigen::Vector3d end = placed.X_BS * Eigen::Vector3d(0, 0, half);
  const Eigen::Vector3d other = placed.X_BS * Eigen::Vector3d(0, 0, -half);
  EXPECT_LT(std::min((end - a).norm() + (other - b).norm(), (end - b).norm() + (other - a).norm()), 1e-7);
}

TEST(Panda, FingerPadsStandApartByTheOpening) {
  const auto panda = shippedRobot("panda");
  const double q[] = {0, -0.785, 0, -2.356, 0, 1.571, 0.785};
  std::vector<Eigen::Isometry3d> X_WL;
  for (const double opening : {0.0, 0.03, 0.08}) {
    panda->linkPoses(q, opening, X_WL);
    // In the frame of the TCP the pads face each other along y, at equal distances.
    double inner[2];
    for (std::size_t i = 0; i < 2; ++i) {
      const auto finger = static_cast<std::size_t>(panda->fingerLinks()[i]);
      const PlacedShape& box = panda->model().links[finger].shapes.front();
      const Eigen::Vector3d centre = panda->tcpPose(q).inverse() * (X_WL[finger] * box.X_BS.translation());
      inner[i] = std::abs(centre.y()) - std::get<Box>(box.shape).size.y() / 2.0;
      EXPECT_NEAR(centre.x(), 0.0, 1e-12);
      // The tips reach 8.8 mm beyond the TCP.
      EXPECT_NEAR(centre.z() + std::get<Box>(box.shape).size.z() / 2.0, 0.0088, 1e-12);
    }
    EXPECT_NEAR(inner[0], opening / 2.0, 1e-12);
    EXPECT_NEAR(inner[1], opening / 2.0, 1e-12);
  }
}

TEST(Panda, SkipsThePairsOfTheFacts) {
  const auto panda = shippedRobot("panda");
  std::set<std::set<std::string>> pairs;
  for (const auto& [a, b] : panda->description().skip_self_collision) {
    EXPECT_GE(panda->model().linkIndex(a), 0) << a;
    EXPECT_GE(panda->model().linkIndex(b), 0) << b;
    EXPECT_TRUE(pairs.insert({a, b}).second) << a << ' ' << b << " is listed twice";
  }
  EXPECT_EQ(pairs.size(), 24u);
  EXPECT_EQ(pairs.count({"panda_hand", "panda_link2"}), 0u);
  EXPECT_EQ(pairs.count({"panda_leftfinger", "panda_link5"}), 0u);
}

TEST(PlanarGripper, TcpFollowsPositionAndHeading) {
  const auto planar = shippedRobot("planar_gripper");
  ASSERT_EQ(planar->dof(), 3);
  const double q[] = {1.5, 2.0, kPi / 6};
  const Eigen::Isometry3d X_WT = planar->tcpPose(q);
  const Eigen::Vector3d heading(std::cos(kPi / 6), std::sin(kPi / 6), 0.0);
  EXPECT_TRUE(X_WT.translation().isApprox(Eigen::Vector3d(1.5, 2.0, 0.0) + 0.18 * heading, 1e-12));
  EXPECT_TRUE(X_WT.linear().col(2).isApprox(heading, 1e-12));
  EXPECT_TRUE(X_WT.linear().col(1).isApprox(Eigen::Vector3d::UnitZ().cross(heading), 1e-12));
  EXPECT_NEAR(X_WT.linear().determinant(), 1.0, 1e-12);
}

TEST(PlanarGripper, BarTouchesTheBodysFrontInThePlane) {
  const auto planar = shippedRobot("planar_gripper");
  const double q[] = {0, 0, 0};
  std::vector<Eigen::Isometry3d> X_WL;
  planar->linkPoses(q, 0.0, X_WL);
  const auto box = [&](const char* name) {
    const PlacedShape& placed = linkNamed(*planar, name).shapes.front();
    const auto index = static_cast<std::size_t>(planar->model().linkIndex(name));
    const Eigen::Vector3d centre = X_WL[index] * placed.X_BS.translation();
    return std::pair(centre, std::get<Box>(placed.shape).size);
  };
  const auto [body, body_size] = box("body");
  const auto [bar, bar_size] = box("gripper");
  EXPECT_EQ(body_size, Eigen::Vector3d(0.30, 0.20, 0.1));
  EXPECT_EQ(bar_size, Eigen::Vector3d(0.03, 0.12, 0.1));
  EXPECT_NEAR(body.x() + body_size.x() / 2, bar.x() - bar_size.x() / 2, 1e-12);
  EXPECT_EQ(bar.z(), 0.0);
  EXPECT_NEAR(planar->tcpPose(q).translation().x(), bar.x() + bar_size.x() / 2, 1e-12);
}

TEST(MobilePanda, IsThePandaMovedByItsBaseWithALongerTool) {
  const auto panda = shippedRobot("panda", unevenPose());
  const auto mobile = shippedRobot("mobile_panda", unevenPose());
  std::mt19937_64 random(3);
  for (int i = 0; i < 100; ++i) {
    Eigen::VectorXd q(9);
    q << 0.3 - 0.01 * i, 0.02 * i - 0.9, randomConfiguration(*panda, random);
    const Eigen::Vector3d moved = unevenPose().linear() * Eigen::Vector3d(q[1], q[0], 0.0);
    const Eigen::Isometry3d expected = Eigen::Translation3d(moved) * panda->tcpPose(q.data() + 2) *
                                       Eigen::Translation3d(0.0, 0.0, 0.105 - 0.1034);
    EXPECT_TRUE(mobile->tcpPose(q.data()).isApprox(expected, 1e-12));
  }
}

TEST(MobilePanda, HasThePublishedLimits) {
  const auto mobile = shippedRobot("mobile_panda");
  Eigen::VectorXd lower(9), upper(9);
  lower << -1, -1, -2.9671, -1.8326, -2.9671, -3.1416, -2.9671, -0.0873, -2.9671;
  upper << 1, 1, 2.9671, 1.8326, 2.9671, 0, 2.9671, 3.8223, 2.9671;
  ASSERT_EQ(mobile->dof(), 9);
  EXPECT_EQ(mobile->lower(), lower);
  EXPECT_EQ(mobile->upper(), upper);
}

TEST(MobilePanda, StandsAboveItsFootAndHoldsTheCapsuleOfLinkZeroAboveIt) {
  const auto panda = shippedRobot("panda");
  const auto mobile = shippedRobot("mobile_panda");
  const PlacedShape& box = linkNamed(*mobile, "panda_link0").shapes.front();
  const PlacedShape& capsule = linkNamed(*panda, "panda_link0").shapes.front();
  const Eigen::Vector3d half = std::get<Box>(box.shape).size / 2.0, middle = box.X_BS.translation();
  EXPECT_NEAR(middle.z() - half.z(), 0.0, 1e-12);
  const double length = std::get<Capsule>(capsule.shape).length,
               radius = std::get<Capsule>(capsule.shape).radius;
  for (const double end : {-0.5, 0.5}) {
    const Eigen::Vector3d p = capsule.X_BS * Eigen::Vector3d(0, 0, end * length);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(p[axis] + radius, middle[axis] + half[axis] + 1e-9);
      if (axis == 2) continue;
      EXPECT_GE(p[axis] - radius, middle[axis] - half[axis] - 1e-9);
    }
  }
  EXPECT_EQ(std::get<Box>(linkNamed(*mobile, "platform").shapes.front().shape).size,
            Eigen::Vector3d(0.4, 0.4, 0.02));
}

}  // namespace
}  // namespace b4p
