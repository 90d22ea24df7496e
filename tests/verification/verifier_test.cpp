// SPDX-License-Identifier: BSD-3-Clause
// Promises: a good path passes; each way of tampering with one fails, with a message of its own.
#include "experiments/verification/verifier.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robots/input_error.h"
#include "verification/gantry.h"

namespace b4p {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Matcher = testing::Matcher<std::string>;

class VerifierTest : public testing::Test {
 protected:
  void expectPasses() {
    const Verification outcome = verify(scene_, result_);
    EXPECT_TRUE(outcome.passed) << outcome.failure;
    EXPECT_EQ(outcome.failure, "");
  }
  void expectFails(const Matcher& message) {
    const Verification outcome = verify(scene_, result_);
    EXPECT_FALSE(outcome.passed);
    EXPECT_THAT(outcome.failure, message);
    EXPECT_EQ(outcome.failure.find('\n'), std::string::npos);
  }
  /// Shifts the whole motion, and what the result says about its ends, along a joint.
  void shiftAll(std::size_t joint, double amount) {
    for (auto& row : result_.path) row[joint] += amount;
  }

  Scene scene_ = test::gantryScene();
  PlanResult result_ = test::gantryResult();
};

TEST_F(VerifierTest, AGoodPathPasses) {
  const Verification outcome = verify(scene_, result_);
  EXPECT_TRUE(outcome.passed) << outcome.failure;
  EXPECT_DOUBLE_EQ(outcome.step_m, scene_.edge_step_m / 10);
  EXPECT_GT(outcome.configurations, 1000);
  // The can stands 5 mm over the table, which is nearer than anything else except fingers.
  EXPECT_NEAR(outcome.clearance_m, 0.005, 1e-6);
}

TEST_F(VerifierTest, TheSceneMayBeNamedByItsFile) {
  result_.scene = scene_.file;
  expectPasses();
}

TEST_F(VerifierTest, AnotherScene) {
  result_.scene = "maze";
  expectFails("scene: 'maze' is not 'over_the_wall'");
}

TEST_F(VerifierTest, Unsolved) {
  result_.solved = false;
  expectFails(HasSubstr("solved: false"));
}

TEST_F(VerifierTest, ApproximateSolution) {
  result_.status = "Approximate solution";
  expectFails(HasSubstr("status: 'Approximate solution'"));
}

TEST_F(VerifierTest, SwappedJointNames) {
  std::swap(result_.joint_names[0], result_.joint_names[1]);
  expectFails("joint_names: 'y' stands where the robot has 'x'");
}

TEST_F(VerifierTest, MissingJointName) {
  result_.joint_names.pop_back();
  expectFails("joint_names: 4 names, the robot has 5");
}

TEST_F(VerifierTest, NoWayPoint) {
  result_.path.clear();
  expectFails("path: has no way-point");
}

TEST_F(VerifierTest, ShortRow) {
  result_.path[2].pop_back();
  expectFails("way-point 2: 4 values for 5 joints");
}

TEST_F(VerifierTest, NonFiniteValue) {
  result_.path[1][3] = std::numeric_limits<double>::quiet_NaN();
  expectFails(AllOf(HasSubstr("way-point 1: joint 'yaw' is not finite"), HasSubstr("nan")));
  result_.path[1][3] = std::numeric_limits<double>::infinity();
  expectFails(HasSubstr("way-point 1: joint 'yaw' is not finite"));
}

TEST_F(VerifierTest, JointBeyondItsLimits) {
  result_.path[1][2] = 2.0 + 1e-8;
  expectFails(HasSubstr("way-point 1: joint 'z' at 2.00000001 is outside its limits [0, 2]"));
  result_.path[1][2] = 2.0 + 1e-10;
  expectPasses();
}

TEST_F(VerifierTest, WayPointInsideAnObstacle) {
  result_.path[2] = {-0.2, 0.6, 0.03, 0.3, 0.0};
  // The table is met on the way there.
  expectFails(AllOf(HasSubstr("edge 1 at 0."), HasSubstr("obstacle 'wall'")));
  scene_.obstacles.pop_back();
  expectFails(AllOf(HasSubstr("edge 1 at 0."), HasSubstr("obstacle 'table'")));
  result_.path.insert(result_.path.begin() + 2, {-0.2, 0.6, 0.5, 0.3, 0.0});
  expectFails(AllOf(HasSubstr("edge 2 at 0."), HasSubstr("obstacle 'table'")));
}

TEST_F(VerifierTest, FirstWayPointInsideAnObstacle) {
  scene_.obstacles.push_back(test::boxObstacle("stone", {0.01, 0.01, 0.01}, {0.5, 0.0, 0.045}));
  expectFails("way-point 0: object 'can' touches obstacle 'stone'");
}

TEST_F(VerifierTest, EdgeThroughAThinObstacleBetweenFreeWayPoints) {
  result_.path[1][2] = result_.path[2][2] = 0.36;
  expectFails(AllOf(HasSubstr("edge 1 at 0."), HasSubstr("object 'can' touches obstacle 'wall'")));
}

TEST_F(VerifierTest, HeldObjectClipsAnObstacleThatTheRobotClears) {
  const double can_bottom_m = 0.5 - 0.05 - 0.01 - 0.04;
  scene_.obstacles.push_back(test::boxObstacle("peg", {0.01, 0.01, can_bottom_m - 0.001}, {-0.2, 0.6, 0}));
  auto& peg = scene_.obstacles.back().shape;
  peg.X_BS.translation().z() = can_bottom_m - 0.001 - (can_bottom_m - 0.001) / 2;
  result_.path.pop_back();  // stays in the air
  scene_.pickPlace().placement.max_m.z() = 1.0;
  result_.X_WO_place.translation().z() = can_bottom_m + 0.04;
  expectPasses();
  peg.X_BS.translation().z() += 0.0015;
  expectFails(AllOf(HasSubstr("edge 1 at 0."), HasSubstr("object 'can' touches obstacle 'peg'")));
}

TEST_F(VerifierTest, HeldObjectAgainstALink) {
  // Over the pillar: its top is 0.42 m high, the can's bottom at 0.40 m, the finger tips at 0.44 m.
  result_.path.insert(result_.path.begin() + 2, {-1.0, 0.0, 0.5, 0.0, 0.0});
  expectFails(AllOf(HasSubstr("edge 1 at 0."), HasSubstr("link 'base' touches object 'can'")));
  scene_.pickPlace().object[0].shape = Box{{0.1, 0.06, 0.02}};
  expectPasses();
}

TEST_F(VerifierTest, LinkAgainstLinkUnlessTheRobotFileSkipsThePair) {
  scene_.pickPlace().object.clear();
  result_.path.insert(result_.path.begin() + 2, {-1.0, 0.0, 0.4, 0.0, 0.0});
  expectFails(AllOf(HasSubstr("edge 1 at 0."), HasSubstr("link 'base' touches link 'hand'")));
  scene_.robot.description.skip_self_collision = {{"hand", "base"}, {"base", "left"}, {"right", "base"}};
  expectPasses();
  scene_.robot.description.skip_self_collision = {{"hand", "pillar"}};
  EXPECT_THROW(verify(scene_, result_), InputError);
}

TEST_F(VerifierTest, FingersMayTouchTheObjectAndThePalmMayNot) {
  scene_.pickPlace().object[0].shape = Box{{0.1, 0.07, 0.08}};
  expectPasses();
  scene_.pickPlace().object[0].shape = Box{{0.1, 0.06, 0.13}};
  scene_.pickPlace().X_WO_start.translation().z() += 0.1;
  result_.X_WO_pick.translation().z() += 0.1;
  result_.X_WO_place.translation().z() += 0.1;
  scene_.pickPlace().placement.max_m.z() += 0.1;
  shiftAll(2, 0.1);
  expectFails("way-point 0: link 'hand' touches object 'can'");
}

TEST_F(VerifierTest, StartShiftedByTwoMillimetres) {
  result_.path[0][0] += 0.002;
  expectFails("way-point 0: the object is 2 mm away from where it is picked up");
  result_.path[0][0] -= 0.0015;
  expectPasses();
}

TEST_F(VerifierTest, StartTurned) {
  result_.path[0][3] += 0.01;
  expectFails(AllOf(HasSubstr("way-point 0: the object is 0.57"), HasSubstr("degrees away")));
}

TEST_F(VerifierTest, EndOutsideTheRegion) {
  result_.path[3][1] = 0.902;
  expectFails("way-point 3: the object is outside the placement region: y = 0.902 m");
}

TEST_F(VerifierTest, NotUpright) {
  result_.path[3][4] = 0.01;
  expectFails(AllOf(HasSubstr("way-point 3: the object is not upright"), HasSubstr("0.57")));
}

TEST_F(VerifierTest, TiltIsAllowedWhereUprightIsNotAsked) {
  scene_.pickPlace().placement.upright = false;
  result_.path[3][4] = 0.01;
  result_.X_WO_place.rotate(Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitX()));
  expectPasses();
}

TEST_F(VerifierTest, YawOutOfItsWindow) {
  result_.path[3][3] = 0.6;
  expectFails(HasSubstr("turned out of the window of yaw: 0.6 rad"));
  scene_.pickPlace().placement.yaw_min_rad = 0.4;
  scene_.pickPlace().placement.yaw_max_rad = 0.7;
  result_.X_WO_place.rotate(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()));
  expectPasses();
}

// 0.3 rad is inside a window that reaches round the back, 0 is not.
TEST_F(VerifierTest, YawWindowMayWrapAround) {
  scene_.pickPlace().placement.yaw_min_rad = 0.2;
  scene_.pickPlace().placement.yaw_max_rad = 0.2 + 6.0;
  expectPasses();
  scene_.pickPlace().placement.yaw_min_rad = 0.4;
  scene_.pickPlace().placement.yaw_max_rad = 6.2;
  expectFails(HasSubstr("window of yaw"));
}

TEST_F(VerifierTest, StatedPickAndPlacePosesHaveToBeThePaths) {
  result_.X_WO_pick.translation().y() += 0.002;
  expectFails("X_WO_pick: is 2 mm away from the path's first object pose");
  result_ = test::gantryResult();
  result_.X_WO_place.translation().y() += 0.002;
  expectFails("X_WO_place: is 2 mm away from the path's last object pose");
}

TEST_F(VerifierTest, StatedPickAndPlaceHaveToBePoses) {
  result_.X_WO_pick.linear() *= 2.0;
  expectFails("X_WO_pick: is not a pose");
  result_ = test::gantryResult();
  result_.X_WO_place.linear() *= 2.0;
  expectFails("X_WO_place: is not a pose");
  result_.X_WO_place.linear().setConstant(std::numeric_limits<double>::quiet_NaN());
  expectFails("X_WO_place: is not a pose");
}

TEST_F(VerifierTest, GraspMoved) {
  result_.grasp.X_OT.translation().x() += 0.005;
  expectFails("way-point 0: the object is 5 mm away from where it is picked up");
}

TEST_F(VerifierTest, GraspOutsideTheBox) {
  result_.grasp.X_OT.translation().x() = 0.051;
  expectFails("grasp: the TCP is outside the box, 0.051 m from its centre");
}

TEST_F(VerifierTest, GraspOffTheMiddle) {
  result_.grasp.X_OT.translation().y() = 0.003;
  expectFails(HasSubstr("grasp: a pad lies inside the box"));
}

TEST_F(VerifierTest, GraspAcrossACorner) {
  result_.grasp.X_OT.rotate(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitZ()));
  expectFails("grasp: the pads do not face two sides of the box");
}

TEST_F(VerifierTest, GraspThatIsNoPose) {
  result_.grasp.X_OT.linear() *= 1.001;
  expectFails("grasp: X_OT is not a pose");
  result_.grasp.X_OT.linear() = Eigen::Vector3d(1, 1, -1).asDiagonal();
  expectFails("grasp: X_OT is not a pose");
  result_.grasp.X_OT(0, 3) = std::numeric_limits<double>::quiet_NaN();
  expectFails("grasp: X_OT is not a pose");
}

TEST_F(VerifierTest, OpeningChanged) {
  result_.grasp.opening_m = 0.059;
  expectFails("grasp: opening of 0.059 m is less than the box's 0.06 m");
  result_.grasp.opening_m = 0.07;
  expectFails("grasp: opening of 0.07 m does not hold the box's 0.06 m");
  result_.grasp.opening_m = 0.081;
  expectFails("grasp: opening of 0.081 m is outside [0, 0.08]");
  result_.grasp.opening_m = -0.01;
  expectFails(HasSubstr("is outside [0, 0.08]"));
  result_.grasp.opening_m = std::numeric_limits<double>::quiet_NaN();
  expectFails(HasSubstr("is outside [0, 0.08]"));
}

TEST_F(VerifierTest, OneWayPointIsAPathWhenPickAndPlaceCoincide) {
  result_.path.resize(1);
  scene_.pickPlace().placement.min_m << 0.4, -0.1, 0.04;
  scene_.pickPlace().placement.max_m << 0.6, 0.1, 0.05;
  result_.X_WO_place = result_.X_WO_pick;
  expectPasses();
  scene_.obstacles.push_back(test::boxObstacle("stone", {0.01, 0.01, 0.01}, {0.5, 0.0, 0.045}));
  expectFails(HasSubstr("way-point 0: object 'can' touches obstacle 'stone'"));
}

TEST_F(VerifierTest, AnEdgeStepNextToNothingIsRefused) {
  scene_.edge_step_m = 1e-300;
  expectFails(AllOf(HasSubstr("edge 0: "), HasSubstr("steps of 1e-301 m are more than the 10000000")));
  scene_.edge_step_m = std::numeric_limits<double>::denorm_min();  // a tenth of it is 0
  expectFails(HasSubstr("edge 0: inf steps"));
  scene_.edge_step_m = 1e-7;
  expectFails(HasSubstr("steps of 1e-08 m are more than the 10000000"));
}

TEST_F(VerifierTest, SceneThatCannotBeUsedIsAnInputError) {
  scene_.robot.urdf_file = "/nowhere/robot.urdf";
  EXPECT_THROW(verify(scene_, result_), InputError);
  scene_ = test::gantryScene();
  scene_.edge_step_m = 0.0;
  EXPECT_THROW(verify(scene_, result_), InputError);
}

/// A stick along x in place of the can, held from above.
class StickGraspTest : public VerifierTest {
 protected:
  StickGraspTest() {
    // The z axis of the stick lies along x of the can it stands for.
    const Eigen::Matrix3d lying = Eigen::AngleAxisd(kHalfPi, Eigen::Vector3d::UnitY()).toRotationMatrix();
    scene_.pickPlace().object = {{Cylinder{0.03, 0.4}, Eigen::Isometry3d::Identity()}};
    scene_.pickPlace().grasps = {};
    scene_.pickPlace().grasps.family = GraspFamily::kStick;
    scene_.pickPlace().grasps.stick_length_m = 0.4;
    scene_.pickPlace().grasps.stick_radius_m = 0.03;
    scene_.pickPlace().grasps.margin_m = 0.05;
    scene_.pickPlace().grasps.finger_depth_m = 0.03;
    scene_.pickPlace().grasps.pad_clearance_m = 0.002;
    scene_.pickPlace().placement.upright = false;
    scene_.pickPlace().X_WO_start.linear() = lying;
    result_.grasp.X_OT = Eigen::Isometry3d(lying.transpose()) * result_.grasp.X_OT;
    result_.X_WO_pick.linear() = lying;
    result_.X_WO_place.linear() = result_.X_WO_place.linear() * lying;
  }

  static constexpr double kHalfPi = 1.57079632679489662;
};

TEST_F(StickGraspTest, AGoodPathPasses) { expectPasses(); }

TEST_F(StickGraspTest, PadsThatCloseAlongTheStick) {
  const Eigen::Matrix3d R = result_.grasp.X_OT.linear();
  result_.grasp.X_OT.linear() = R * Eigen::AngleAxisd(kHalfPi, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  expectFails("grasp: the pads do not close across the stick");
}

TEST_F(StickGraspTest, HandThatLeansAlongTheStick) {
  const Eigen::Matrix3d R = result_.grasp.X_OT.linear();
  result_.grasp.X_OT.linear() = R * Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitY()).toRotationMatrix();
  expectFails("grasp: the hand does not stand across the stick");
}

TEST_F(StickGraspTest, TooNearTheEnd) {
  result_.grasp.X_OT.translation().z() = 0.151;
  expectFails(HasSubstr("past the margin"));
}

TEST_F(StickGraspTest, PadInsideTheStickOrStickOutsideThePads) {
  const Eigen::Isometry3d good = result_.grasp.X_OT;
  result_.grasp.X_OT.translation() += 0.003 * good.linear().col(1);
  expectFails(HasSubstr("a pad lies inside the stick"));
  result_.grasp.X_OT.translation() = good.translation() - 0.05 * good.linear().col(2);
  expectFails("grasp: the stick is not between the pads");
}

TEST_F(StickGraspTest, OpeningThatDoesNotHoldIt) {
  result_.grasp.opening_m = 0.059;
  expectFails(HasSubstr("less than the stick is thick"));
  result_.grasp.opening_m = 0.07;
  expectFails(HasSubstr("does not hold the stick"));
}

TEST_F(VerifierTest, AListedGraspIsTheOneOfItsRow) {
  scene_.pickPlace().grasps = {};
  scene_.pickPlace().grasps.family = GraspFamily::kListed;
  scene_.pickPlace().grasps.listed = {Grasp(), result_.grasp};
  result_.grasp_id = 1;
  expectPasses();
  result_.grasp_id = 0;
  expectFails(HasSubstr("from the one of row 1"));
  result_.grasp_id = 2;
  expectFails("grasp: row 3 is none of the 2 listed");
  result_.grasp_id = 1;
  scene_.pickPlace().grasps.listed[1].opening_m -= 1e-5;
  expectFails(HasSubstr("m of row 2"));
}

/// A triangle pushed about by a disc whose front is the TCP.
class EdgeGraspTest : public VerifierTest {
 protected:
  EdgeGraspTest() {
    scene_.robot.urdf_file = test::writeFile(
        "disc.urdf",
        "<robot name='disc'><link name='world'/><link name='slide'/><link name='slide_y'/><link name='disc'>"
        "<collision><geometry><cylinder radius='.05' length='.02'/></geometry></collision></link><link "
        "name='tip'/>"
        "<joint name='x' type='prismatic'><parent link='world'/><child link='slide'/><axis xyz='1 0 0'/>"
        "<limit lower='-5' upper='5'/></joint>"
        "<joint name='y' type='prismatic'><parent link='slide'/><child link='slide_y'/><axis xyz='0 1 0'/>"
        "<limit lower='-5' upper='5'/></joint>"
        "<joint name='turn' type='continuous'><parent link='slide_y'/><child link='disc'/><axis xyz='0 0 "
        "1'/></joint>"
        "<joint name='front' type='fixed'><parent link='disc'/><child link='tip'/>"
        "<origin xyz='.06 0 0' rpy='0 1.5707963267948966 0'/></joint></robot>");
    scene_.robot.description = {};
    scene_.robot.description.joints = {"x", "y", "turn"};
    scene_.robot.description.tcp_link = "tip";
    scene_.obstacles = {test::boxObstacle("wall", {1, 0.01, 1}, {0, 2, 0})};
    scene_.pickPlace().grasps.family = GraspFamily::kPolygonEdges;
    scene_.pickPlace().grasps.polygon_m = {{0, 0}, {0.4, 0}, {0, 0.4}};
    scene_.pickPlace().grasps.pad_clearance_m = 0.01;
    scene_.pickPlace().object = {
        {Box{{0.1, 0.1, 0.02}}, Eigen::Isometry3d(Eigen::Translation3d(0.1, 0.1, 0))}};
    scene_.pickPlace().X_WO_start =
        Eigen::Translation3d(0.06 + 0.01, -0.2, 0) * Eigen::Quaterniond::Identity();
    scene_.pickPlace().placement.min_m << 0, -1, -0.001;
    scene_.pickPlace().placement.max_m << 2, 1, 0.001;
    scene_.pickPlace().placement.yaw_min_rad = -3.2;
    scene_.pickPlace().placement.yaw_max_rad = 3.2;
    // Edge 2 runs down the y axis from (0, 0.4) to (0, 0); inwards is +x.
    result_.grasp_id = 2;
    result_.grasp.opening_m = 0.0;
    result_.grasp.X_OT.translation() << -0.01, 0.2, 0;
    result_.grasp.X_OT.linear() << 0, 0, 1, 0, 1, 0, -1, 0, 0;
    result_.joint_names = {"x", "y", "turn"};
    result_.path = {{0, 0, 0}, {1, 0.5, 0.0}};
    result_.X_WO_pick = scene_.pickPlace().X_WO_start;
    result_.X_WO_place = Eigen::Translation3d(1, 0.5, 0) * result_.X_WO_pick;
  }
};

TEST_F(EdgeGraspTest, AGoodPathPasses) { expectPasses(); }

TEST_F(EdgeGraspTest, AnotherEdgeThanTheOneNamed) {
  result_.grasp_id = 1;
  expectFails(HasSubstr("from the one of edge 1"));
  result_.grasp_id = 3;
  expectFails("grasp: id 3 is none of the 3 edges");
  result_.grasp_id = -1;
  expectFails("grasp: id -1 is none of the 3 edges");
}

TEST_F(EdgeGraspTest, ShiftedAlongTheEdge) {
  result_.grasp.X_OT.translation().y() += 2e-6;
  expectFails(HasSubstr("from the one of edge 2"));
}

TEST_F(EdgeGraspTest, ObjectAgainstTheRobotThatHoldsIt) {
  scene_.pickPlace().object.push_back({Sphere{0.01}, Eigen::Isometry3d(Eigen::Translation3d(-0.03, 0.2, 0))});
  expectFails("way-point 0: link 'disc' touches object 'can'");
}

}  // namespace
}  // namespace b4p
