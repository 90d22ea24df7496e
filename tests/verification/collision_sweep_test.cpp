// SPDX-License-Identifier: BSD-3-Clause
// Promises: leaving samples out changes neither verdict, place of contact nor clearance; nothing that is
// thicker than nothing is passed through.
#include "experiments/verification/collision_sweep.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "verification/gantry.h"

namespace b4p::verification {
namespace {

constexpr double kStep_m = 0.001;

class CollisionSweepTest : public testing::Test {
 protected:
  CollisionSweepTest() : scene_(test::gantryScene()), robot_(makeRobot()) {
    std::uniform_real_distribution<double> place(-0.8, 0.8), side(0.02, 0.2);
    for (int i = 0; i < 12; ++i)
      scene_.obstacles.push_back(
          test::boxObstacle("block" + std::to_string(i), {side(random_), side(random_), side(random_)},
                            {place(random_), place(random_), 0.5 + place(random_) / 2}));
    scene_.obstacles.push_back(
        {"ball", {Sphere{0.1}, Eigen::Isometry3d(Eigen::Translation3d(0.3, 0.3, 0.6))}});
  }

  Kinematics makeRobot() const {
    return Kinematics(scene_.robot.urdf_file, scene_.robot.description, scene_.X_WB);
  }

  Eigen::VectorXd randomConfiguration() {
    std::uniform_real_distribution<double> unit(0, 1);
    Eigen::VectorXd q(5);
    q << -0.8 + 1.6 * unit(random_), -0.8 + 1.6 * unit(random_), 0.2 + 0.8 * unit(random_),
        -2 + 4 * unit(random_), -0.8 + 1.6 * unit(random_);
    return q;
  }

  std::mt19937_64 random_{11};
  Scene scene_;
  Kinematics robot_;
};

TEST_F(CollisionSweepTest, FindsWhatMeasuringEverySampleFinds) {
  const Grasp grasp = test::gantryResult().grasp;
  int blocked = 0, free = 0;
  for (int edge = 0; edge < 150; ++edge) {
    const Eigen::VectorXd q1 = randomConfiguration(), q2 = q1 + 0.3 * (randomConfiguration() - q1);
    CollisionSweep sweep(scene_, robot_, grasp, kStep_m);
    const auto contact = sweep.firstContact(q1, q2);
    const long steps = sweep.samples() - 1;
    // A sweep from a configuration to itself measures everything at that sample.
    CollisionSweep everything(scene_, robot_, grasp, kStep_m);
    long first = -1;
    for (long i = 0; i <= steps && first < 0; ++i) {
      const double fraction = static_cast<double>(i) / static_cast<double>(steps);
      const Eigen::VectorXd q = i < steps ? Eigen::VectorXd(q1 + fraction * (q2 - q1)) : q2;
      if (everything.firstContact(q, q)) first = i;
    }
    ASSERT_EQ(contact.has_value(), first >= 0) << edge;
    if (contact) {
      EXPECT_DOUBLE_EQ(contact->fraction, static_cast<double>(first) / static_cast<double>(steps));
      ++blocked;
    } else {
      EXPECT_NEAR(sweep.clearance_m(), everything.clearance_m(), 1e-7);
      ++free;
    }
  }
  EXPECT_GT(blocked, 20);
  EXPECT_GT(free, 20);
}

TEST_F(CollisionSweepTest, SamplesLieNoFartherApartThanTheStep) {
  Eigen::VectorXd q1 = Eigen::VectorXd::Zero(5), q2 = q1;
  q1[2] = q2[2] = 1.5;
  q2[0] = 1.0;
  CollisionSweep sweep(scene_, robot_, test::gantryResult().grasp, kStep_m);
  sweep.firstContact(q1, q2);
  EXPECT_GE(sweep.samples(), 1001);
  sweep.firstContact(q2, q1);
  EXPECT_GE(sweep.samples(), 2001);
}

TEST_F(CollisionSweepTest, EdgesOfTooManyStepsAreNotSwept) {
  const Eigen::VectorXd q1 = Eigen::VectorXd::Zero(5);
  Eigen::VectorXd q2 = q1;
  q2[3] = std::numeric_limits<double>::max();
  CollisionSweep sweep(scene_, robot_, test::gantryResult().grasp, kStep_m);
  EXPECT_GT(sweep.steps(q1, q2), CollisionSweep::kMostSteps);
  EXPECT_GT(sweep.steps(-q2, q2), CollisionSweep::kMostSteps) << "a change that overflows";
  EXPECT_THROW(sweep.firstContact(q1, q2), std::length_error);
  EXPECT_EQ(sweep.samples(), 0);
}

TEST_F(CollisionSweepTest, SeesAPlateOfOneStepAcrossTheWay) {
  Eigen::VectorXd q1 = Eigen::VectorXd::Zero(5), q2 = q1;
  q1[2] = q2[2] = 1.5;
  q1[0] = -1.5;
  q2[0] = 1.5;
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  for (int i = 0; i < 50; ++i) {
    scene_.obstacles = {test::boxObstacle("plate", {1e-6, 0.02, 0.02}, {place(random_), 0, 1.41})};
    CollisionSweep sweep(scene_, robot_, test::gantryResult().grasp, kStep_m);
    const auto contact = sweep.firstContact(q1, q2);
    ASSERT_TRUE(contact.has_value());
    EXPECT_EQ(contact->first, "object 'can'");
    EXPECT_EQ(contact->second, "obstacle 'plate'");
  }
}

TEST_F(CollisionSweepTest, NothingToTouchMeansNoClearance) {
  scene_.obstacles.clear();
  scene_.pickPlace().object.clear();
  scene_.robot.description.skip_self_collision = {
      {"base", "hand"}, {"base", "left"}, {"base", "right"}, {"left", "right"}};
  CollisionSweep sweep(scene_, robot_, {}, kStep_m);
  EXPECT_FALSE(sweep.firstContact(randomConfiguration(), randomConfiguration()).has_value());
  EXPECT_EQ(sweep.clearance_m(), 0.0);
}

/// Balls on a line, each larger than its distance from the next: a and b turn against each other, b and c are
/// fixed, c and d turn, e hangs on a by a joint that is never moved.
class LinkPairsTest : public testing::Test {
 protected:
  LinkPairsTest() {
    std::string xml = "<robot name='balls'>";
    for (const char* link : {"a", "b", "c", "d", "e"})
      xml += "<link name='" + std::string(link) +
             "'><collision><geometry><sphere radius='.1'/></geometry></collision></link>";
    const auto joint = [&](const char* type, const std::string& parent, const std::string& child, double x) {
      xml += "<joint name='" + parent + child + "' type='" + type + "'><parent link='" + parent +
             "'/><child link='" + child + "'/><origin xyz='" + std::to_string(x) +
             " 0 0'/><limit lower='-1' upper='1'/></joint>";
    };
    joint("revolute", "a", "b", 0.15);
    joint("fixed", "b", "c", 0.15);
    joint("revolute", "c", "d", 0.15);
    joint("revolute", "a", "e", -0.15);
    scene_.robot.urdf_file = test::writeFile("balls.urdf", xml + "</robot>");
    scene_.robot.description.joints = {"ab", "cd"};
    scene_.robot.description.tcp_link = "d";
  }

  /// What touches with all joints at zero, "" when nothing does.
  std::string contact() {
    const Kinematics robot(scene_.robot.urdf_file, scene_.robot.description, scene_.X_WB);
    CollisionSweep sweep(scene_, robot, {}, kStep_m);
    const Eigen::VectorXd q = Eigen::VectorXd::Zero(2);
    const auto found = sweep.firstContact(q, q);
    return found ? found->first + ", " + found->second : "";
  }

  Scene scene_;
};

TEST_F(LinkPairsTest, NeighboursAndLinksThatNoPathMovesApartAreNotCompared) { EXPECT_EQ(contact(), ""); }

TEST_F(LinkPairsTest, ClearanceIsExactBetweenThingsFarApart) {
  // Among themselves the balls lie closer than anything else: leave only the peas to measure to.
  for (const auto& pair : {std::pair("a", "c"), std::pair("a", "d"), std::pair("b", "e"), std::pair("c", "e"),
                           std::pair("d", "e")})
    scene_.robot.description.skip_self_collision.emplace_back(pair.first, pair.second);
  for (const double x : {5.0, 5.2, -7.0})
    scene_.obstacles.push_back({"pea", {Sphere{0.01}, Eigen::Isometry3d(Eigen::Translation3d(x, 0, 0))}});
  const Kinematics robot(scene_.robot.urdf_file, scene_.robot.description, scene_.X_WB);
  CollisionSweep sweep(scene_, robot, {}, kStep_m);
  const Eigen::VectorXd q = Eigen::VectorXd::Zero(2);
  EXPECT_FALSE(sweep.firstContact(q, q).has_value());
  EXPECT_NEAR(sweep.clearance_m(), 5.0 - 0.01 - 0.45 - 0.1, 1e-6);  // d is the ball that lies farthest out
}

TEST_F(LinkPairsTest, OtherLinksAre) {
  // d reaches past b to a, through which no joint leads directly.
  scene_.robot.urdf_file = test::writeFile(
      "folded.urdf",
      "<robot name='r'><link name='a'><collision><geometry><sphere "
      "radius='.1'/></geometry></collision></link>"
      "<link name='b'/><link name='d'><collision><geometry><sphere "
      "radius='.1'/></geometry></collision></link>"
      "<joint name='ab' type='revolute'><parent link='a'/><child link='b'/><origin xyz='.3 0 0'/>"
      "<limit lower='-1' upper='1'/></joint>"
      "<joint name='cd' type='revolute'><parent link='b'/><child link='d'/><origin xyz='-.15 0 0'/>"
      "<limit lower='-1' upper='1'/></joint></robot>");
  EXPECT_EQ(contact(), "link 'a', link 'd'");
}

TEST_F(LinkPairsTest, WhatNoPathMovesMayStandInAnObstacle) {
  scene_.obstacles = {test::boxObstacle("floor", {0.02, 0.02, 0.02}, {-0.05, 0, 0})};  // in a and e
  EXPECT_EQ(contact(), "");
  scene_.obstacles = {test::boxObstacle("floor", {0.02, 0.02, 0.02}, {0.15, 0, 0})};
  EXPECT_EQ(contact(), "link 'b', obstacle 'floor'");
}

TEST_F(LinkPairsTest, TheHeldObjectIsComparedWithAllLinksButFingers) {
  scene_.pickPlace().object = {{Sphere{0.01}, Eigen::Isometry3d::Identity()}};
  scene_.pickPlace().object_name = "bead";
  EXPECT_EQ(contact(), "link 'd', object 'bead'");
  scene_.robot.description.finger_links = {"d"};
  EXPECT_EQ(contact(), "");
}

TEST_F(LinkPairsTest, TheObjectOfAPlacementTaskIsSweptToo) {
  PlacementTask task;
  task.object = {{Sphere{0.01}, Eigen::Isometry3d::Identity()}};
  task.object_name = "bead";
  scene_.task = task;
  EXPECT_EQ(contact(), "link 'd', object 'bead'");
}

}  // namespace
}  // namespace b4p::verification
