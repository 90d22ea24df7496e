// SPDX-License-Identifier: BSD-3-Clause
// Antipodal grasps touch the object at two points with opposed normals, fit the gripper, keep the open hand
// clear of the object, and are the same for the same seed.
#include "experiments/samplers/antipodal_grasps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "experiments/scene.h"
#include "state_validity/collision_checker.h"

namespace b4p::test {
namespace {

constexpr double kOpening_m = 0.08;

PlacedShape at(const Shape& shape, const Eigen::Isometry3d& X = Eigen::Isometry3d::Identity()) {
  return {shape, X};
}

Eigen::Isometry3d uneven() {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translate(Eigen::Vector3d(0.3, -0.2, 0.5))
      .rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  return X;
}

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all{Box{{0.05, 0.06, 0.09}}, Sphere{0.03}, Cylinder{0.02, 0.05},
                                      Capsule{0.02, 0.07}};
  return all;
}

TEST(Surface, PointsDrawnLieOnItAndNormalsLeadOut) {
  std::mt19937_64 random(1);
  for (const Shape& shape : shapes()) {
    const Surface surface(at(shape, uneven()));
    for (int draw = 0; draw < 1000; ++draw) {
      const Eigen::Vector3d p = surface.sample(random), n = surface.normal(p);
      EXPECT_NEAR(surface.signedDistance(p), 0.0, 1e-12);
      EXPECT_NEAR(n.norm(), 1.0, 1e-12);
      EXPECT_NEAR(surface.signedDistance(p + 0.004 * n), 0.004, 1e-12);
      EXPECT_LT(surface.signedDistance(p - 1e-5 * n), 0.0);
    }
  }
}

// The share of points on one side of a plane is that of the area there.
TEST(Surface, PointsAreUniformByArea) {
  constexpr int kDraws = 20000;
  constexpr double kPi = 3.14159265358979323846;
  const struct {
    Shape shape;
    double share_above_15mm;
  } cases[] = {{Box{{0.05, 0.06, 0.09}}, (0.003 + 2 * 0.11 * 0.03) / (2 * 0.003 + 2 * 0.11 * 0.09)},
               {Sphere{0.03}, 0.25},
               {Cylinder{0.02, 0.05}, (0.02 / 2 + 0.01) / (0.05 + 0.02)},
               {Capsule{0.02, 0.07}, 0.04 / 0.11}};
  std::mt19937_64 random(2);
  for (const auto& [shape, share] : cases) {
    const Surface surface(at(shape));
    int above = 0;
    for (int draw = 0; draw < kDraws; ++draw) above += surface.sample(random).z() > 0.015 ? 1 : 0;
    EXPECT_NEAR(above / double(kDraws), share, 0.018);  // five standard deviations
  }
  EXPECT_NEAR(Surface(at(Sphere{0.03})).area_m2(), 4 * kPi * 0.0009, 1e-12);
  EXPECT_NEAR(Surface(at(Capsule{0.02, 0.07})).area_m2(), 2 * kPi * 0.02 * 0.11, 1e-12);
  EXPECT_NEAR(Surface(at(Cylinder{0.02, 0.05})).area_m2(), 2 * kPi * 0.02 * 0.07, 1e-12);
  EXPECT_NEAR(Surface(at(Box{{1, 2, 3}})).area_m2(), 22.0, 1e-12);
}

TEST(Surface, RefusesMeshes) {
  const auto mesh = convexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_THROW(Surface(at(mesh)), std::invalid_argument);
}

TEST(AntipodalSampler, ContactsLieOnTheSurfaceWithNormalsInsideTheCone) {
  AntipodalRules rules;
  rules.pad_clearance_m = 0.002;
  rules.contact_depth_m = 0.004;
  std::mt19937_64 random(3);
  for (const Shape& shape : shapes()) {
    const Surface surface(at(shape, uneven()));
    const AntipodalSampler sampler({at(shape, uneven())}, kOpening_m, rules);
    int found = 0;
    for (int draw = 0; draw < 5000; ++draw) {
      const auto grasp = sampler.draw(random);
      if (!grasp) continue;
      ++found;
      const Eigen::Matrix3d R = grasp->X_OT.linear();
      EXPECT_NEAR(R.determinant(), 1.0, 1e-9);
      EXPECT_NEAR((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 0.0, 1e-9);
      EXPECT_LE(grasp->opening_m, kOpening_m);
      const Eigen::Vector3d middle = grasp->X_OT.translation() - 0.004 * R.col(2);
      for (const double side : {-1.0, 1.0}) {
        const Eigen::Vector3d p = middle + side * (grasp->opening_m / 2 - 0.002) * R.col(1);
        EXPECT_NEAR(surface.signedDistance(p), 0.0, 1e-9);
        EXPECT_GE(surface.normal(p).dot(side * R.col(1)), std::cos(rules.friction_cone_rad) - 1e-6);
      }
    }
    EXPECT_GT(found, 100);
  }
}

TEST(AntipodalSampler, RollIsUniformAboutTheClosingAxis) {
  const AntipodalSampler sampler({at(Sphere{0.03})}, kOpening_m, {});
  std::mt19937_64 random(4);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  int found = 0;
  while (found < 20000) {
    const auto grasp = sampler.draw(random);
    if (!grasp) continue;
    mean += grasp->X_OT.linear().col(2);
    ++found;
  }
  EXPECT_LT((mean / found).norm(), 0.03);
}

TEST(AntipodalSampler, LeavesOutWhatDoesNotFitTheGripper) {
  std::mt19937_64 random(5);
  const AntipodalSampler too_wide({at(Box{{0.2, 0.2, 0.2}})}, kOpening_m, {});
  const AntipodalSampler one_way({at(Box{{0.2, 0.05, 0.2}})}, kOpening_m, {});
  for (int draw = 0; draw < 2000; ++draw) {
    EXPECT_FALSE(too_wide.draw(random));
    if (const auto grasp = one_way.draw(random)) {
      EXPECT_GE(std::abs(grasp->X_OT.linear()(1, 1)), std::cos(AntipodalRules().friction_cone_rad));
    }
  }
}

TEST(AntipodalSampler, ContactsAreNotInsideAnotherPiece) {
  // A short wide disc hides the middle of a rod.
  const std::vector<PlacedShape> object{at(Cylinder{0.01, 0.2}), at(Cylinder{0.045, 0.1})};
  const AntipodalSampler sampler(object, kOpening_m, {});
  std::mt19937_64 random(6);
  int found = 0;
  for (int draw = 0; draw < 5000; ++draw)
    if (const auto grasp = sampler.draw(random)) {
      ++found;
      EXPECT_GT(std::abs(grasp->X_OT.translation().z()), 0.045);
    }
  EXPECT_GT(found, 100);
}

TEST(AntipodalSampler, RefusesRulesOutOfRange) {
  const std::vector<PlacedShape> ball{at(Sphere{0.03})};
  AntipodalRules rules;
  rules.friction_cone_rad = 1.6;
  EXPECT_THROW(AntipodalSampler(ball, kOpening_m, rules), std::invalid_argument);
  rules = {};
  rules.pad_clearance_m = std::nan("");
  EXPECT_THROW(AntipodalSampler(ball, kOpening_m, rules), std::invalid_argument);
  EXPECT_THROW(AntipodalSampler({}, kOpening_m, {}), std::invalid_argument);
}

class AntipodalGrasps : public ::testing::Test {
 protected:
  AntipodalGrasps() {
    const RobotFile file = loadRobotFile("mobile_panda");
    robot_ = std::make_shared<const Manipulator>(loadUrdf(file.urdf_file), file.description,
                                                 Eigen::Isometry3d::Identity(), file.file);
  }
  std::shared_ptr<const Manipulator> robot_;
};

// The whole robot is put to each grasp by moving the object instead of the hand.
TEST_F(AntipodalGrasps, KeepTheOpenHandClearOfTheObject) {
  const double q[] = {0, 0, 0, -0.76, 0, -2.34, 0, 1.54, 0.75};
  const Eigen::Isometry3d X_WT = robot_->tcpPose(q);
  AntipodalRules rules;
  for (const Shape& shape : shapes()) {
    const std::vector<Grasp> grasps = antipodalGrasps(robot_, {at(shape)}, {}, rules, 50, 7);
    ASSERT_EQ(grasps.size(), 50u);
    for (const Grasp& grasp : grasps) {
      CollisionProblem problem;
      problem.robot = robot_;
      problem.padding_m = 0.9 * rules.hand_clearance_m;
      problem.obstacles = {{"object", at(shape, X_WT * grasp.X_OT.inverse())}};
      EXPECT_EQ(makeFclChecker(problem)->makeContext()->describeCollision(q, nullptr), "");
    }
  }
}

TEST_F(AntipodalGrasps, KeepFingersAboveWhatTheObjectStandsOnButNotTheHand) {
  constexpr double kFloor_m = -0.0335;
  const PlacedShape floor{Box{{2, 2, 0.1}}, Eigen::Isometry3d(Eigen::Translation3d(0, 0, kFloor_m - 0.05))};
  int hands_below = 0;
  for (const Grasp& grasp : antipodalGrasps(robot_, {at(Sphere{0.0335})}, {floor}, {}, 200, 3))
    for (const double side : {-1.0, 1.0}) {
      for (const double y : {0.04, 0.0664}) {  // a finger's tip, inner and outer edge
        const Eigen::Vector3d tip = grasp.X_OT * Eigen::Vector3d(0.0, side * y, 0.0072);
        EXPECT_GE(tip.z(), kFloor_m - 1e-9);
      }
      hands_below += (grasp.X_OT * Eigen::Vector3d(0.0, side * 0.1, -0.039)).z() < kFloor_m ? 1 : 0;
    }
  EXPECT_GT(hands_below, 0);
}

TEST_F(AntipodalGrasps, AreTheSameForTheSameSeedAndOthersForAnother) {
  const auto poses = [&](std::uint64_t seed) {
    std::vector<double> numbers;
    for (const Grasp& grasp : antipodalGrasps(robot_, {at(Sphere{0.0335})}, {}, {}, 20, seed))
      numbers.insert(numbers.end(), grasp.X_OT.matrix().data(), grasp.X_OT.matrix().data() + 16);
    return numbers;
  };
  EXPECT_EQ(poses(8), poses(8));
  EXPECT_NE(poses(8), poses(9));
}

TEST_F(AntipodalGrasps, SayWhenThereAreNotEnough) {
  EXPECT_THROW(antipodalGrasps(robot_, {at(Sphere{0.06})}, {}, {}, 1, 1), std::invalid_argument);
}

}  // namespace
}  // namespace b4p::test
