// SPDX-License-Identifier: BSD-3-Clause
// Promises: a path of an empty hand to a grasp passes; each way of tampering with one fails.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/verification/verifier.h"
#include "verification/gantry.h"

namespace b4p {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double kDegree_rad = 3.14159265358979323846 / 180.0;

/// Where the gantry's TCP is with an untilted hand.
Eigen::Isometry3d tcpPose(const std::vector<double>& q) {
  Eigen::Isometry3d X(Eigen::Translation3d(q[0], q[1], q[2] - 0.05));
  X.linear() = Eigen::AngleAxisd(q[3], Eigen::Vector3d::UnitZ()) * Eigen::Vector3d(1, -1, -1).asDiagonal();
  return X;
}

/// The hand goes over the wall and comes down around a can, with 1 cm between can and fingers.
class ReachVerifier : public testing::Test {
 protected:
  ReachVerifier() {
    scene_.obstacles.push_back(test::boxObstacle("can", {0.1, 0.06, 0.08}, {-0.2, 0.6, 0.041}));
    ReachTask task;
    task.start = {0.5, 0.0, 0.5, 0.0, 0.0};
    task.X_WT = {tcpPose({0.0, 0.0, 0.1, 0.0}), tcpPose({-0.2, 0.6, 0.1, 0.0})};
    scene_.task = task;
    result_.grasp_id = 1;
    result_.path = {task.start, {-0.2, 0.6, 0.5, 0.0, 0.0}, {-0.2, 0.6, 0.1, 0.0, 0.0}};
    result_.X_WT_reached = task.X_WT[1];
  }

  ReachTask& task() { return std::get<ReachTask>(scene_.task); }
  void endAt(const std::vector<double>& q) {
    result_.path.back() = q;
    result_.X_WT_reached = tcpPose(q);
  }
  void expectPasses() {
    const Verification outcome = verify(scene_, result_);
    EXPECT_TRUE(outcome.passed) << outcome.failure;
  }
  void expectFails(const testing::Matcher<std::string>& message) {
    const Verification outcome = verify(scene_, result_);
    EXPECT_FALSE(outcome.passed);
    EXPECT_THAT(outcome.failure, message);
    EXPECT_EQ(outcome.failure.find('\n'), std::string::npos);
  }

  Scene scene_ = test::gantryScene();
  PlanResult result_ = test::gantryResult();
};

TEST_F(ReachVerifier, AGoodPathPasses) {
  const Verification outcome = verify(scene_, result_);
  EXPECT_TRUE(outcome.passed) << outcome.failure;
  EXPECT_DOUBLE_EQ(outcome.step_m, scene_.edge_step_m / 10);
  EXPECT_GT(outcome.configurations, 1000);
  EXPECT_NEAR(outcome.clearance_m, 0.01, 1e-6) << "between can and open fingers";
}

TEST_F(ReachVerifier, AnotherStart) {
  result_.path[0][1] = 1e-6;
  expectFails(HasSubstr("way-point 0: joint 'y' at 1e-06 is not at the scene's start, 0"));
  result_.path.erase(result_.path.begin());
  expectFails(HasSubstr("way-point 0: joint 'x'"));
}

TEST_F(ReachVerifier, TheTcpTooFarFromTheGrasp) {
  endAt({-0.2, 0.6, 0.1009, 0.0, 0.0});
  expectPasses();
  endAt({-0.2, 0.6, 0.102, 0.0, 0.0});
  expectFails("way-point 2: the TCP is 2 mm away from grasp 1");
  task().position_tolerance_m = 0.003;
  expectPasses();
}

TEST_F(ReachVerifier, TheTcpTurnedAwayFromTheGrasp) {
  endAt({-0.2, 0.6, 0.1, 0.4 * kDegree_rad, 0.0});
  expectPasses();
  endAt({-0.2, 0.6, 0.1, 1.0 * kDegree_rad, 0.0});
  expectFails("way-point 2: the TCP is 1 degrees away from grasp 1");
}

TEST_F(ReachVerifier, AFlipOnlyWhereItCountsAsTheSame) {
  task().X_WT[1] = task().X_WT[1] * Eigen::AngleAxisd(180.0 * kDegree_rad, Eigen::Vector3d::UnitZ());
  expectPasses();
  task().flip = false;
  expectFails(HasSubstr("the TCP is 180 degrees away from grasp 1"));
}

TEST_F(ReachVerifier, ATurnAboutAnotherAxisIsNoFlip) {
  task().X_WT[1] = task().X_WT[1] * Eigen::AngleAxisd(180.0 * kDegree_rad, Eigen::Vector3d::UnitX());
  expectFails(HasSubstr("the TCP is 180 degrees away from grasp 1"));
}

TEST_F(ReachVerifier, AFreeOrientationAndItsTolerance) {
  task().orientation_free = true;
  task().position_tolerance_m = 0.05;
  endAt({-0.2, 0.6, 0.14, 0.2, 0.0});
  expectPasses();
  endAt({-0.2, 0.6, 0.16, 0.2, 0.0});
  expectFails(HasSubstr("the TCP is 60 mm away"));
}

TEST_F(ReachVerifier, AnotherGraspThanStated) {
  result_.grasp_id = 0;
  expectFails(HasSubstr("away from grasp 0"));
  for (const int none : {-1, 2}) {
    result_.grasp_id = none;
    expectFails(HasSubstr("is none of the 2 grasps"));
  }
}

TEST_F(ReachVerifier, AnotherPoseThanStated) {
  result_.X_WT_reached->translation().x() += 1e-4;
  expectFails(HasSubstr("X_WT_reached: differs by 0.0001"));
  result_.X_WT_reached.reset();
  expectFails("X_WT_reached: is missing");
}

TEST_F(ReachVerifier, AnEdgeThroughTheTarget) {
  task().start = {-0.2, 0.3, 0.1, 0.0, 0.0};
  result_.path = {task().start, result_.path.back()};
  expectFails(AllOf(HasSubstr("edge 0 at 0."), HasSubstr("touches obstacle 'can'")));
}

TEST_F(ReachVerifier, TheFingersAreFullyOpen) {
  scene_.obstacles.back() = test::boxObstacle("can", {0.1, 0.079, 0.08}, {-0.2, 0.6, 0.041});
  expectPasses();
  scene_.obstacles.back() = test::boxObstacle("can", {0.1, 0.081, 0.08}, {-0.2, 0.6, 0.041});
  expectFails(AllOf(HasSubstr("edge 1 at 0."), HasSubstr("touches obstacle 'can'")));
}

TEST_F(ReachVerifier, JointLimitsAndSelfCollision) {
  result_.path[1][2] = 2.1;
  expectFails(HasSubstr("way-point 1: joint 'z'"));
  result_.path[1][2] = 0.5;
  result_.path.insert(result_.path.begin() + 1, {-1.0, 0.0, 0.45, 0.0, 0.0});
  expectFails(AllOf(HasSubstr("edge 0 at "), HasSubstr("touches"), HasSubstr("link 'base'")));
}

TEST_F(ReachVerifier, TheSceneMayBeNamedByItsFolderAndFile) {
  for (const char* name : {"somewhere/over_the_wall", "over_the_wall", "/somewhere/over_the_wall.yaml"}) {
    result_.scene = name;
    expectPasses();
  }
  for (const char* name : {"elsewhere/over_the_wall", "the_wall", "wall", ""}) {
    result_.scene = name;
    expectFails(HasSubstr("scene: "));
  }
}

}  // namespace
}  // namespace b4p
