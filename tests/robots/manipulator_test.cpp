// SPDX-License-Identifier: BSD-3-Clause
#include "robots/manipulator.h"

#include <cmath>
#include <limits>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robots/input_error.h"
#include "robots/shipped_robot.h"
#include "robots/temporary_folder.h"

// Promises: names are resolved or complained of, joints that do not take part rest at the value nearest to
// zero, limits are inclusive, the base is where it is put.

namespace b4p {
namespace {

using testing::HasSubstr;

/// An arm of two joints with a passive joint and two fingers beside it.
RobotModel arm(const std::string& finger_extra = "") {
  const TemporaryFolder folder;
  return loadUrdf(folder.write("arm.urdf", R"(<robot name="arm">
    <link name="base"/><link name="upper"/><link name="lower"/><link name="tool"/><link name="flap"/>
    <link name="left"/><link name="right"/>
    <joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/><origin xyz="0 0 1"/>
      <axis xyz="0 0 1"/><limit lower="-1" upper="2" velocity="1" effort="1"/></joint>
    <joint name="slide" type="prismatic"><parent link="upper"/><child link="lower"/><origin rpy="0 0 1.5707963267948966"/>
      <axis xyz="1 0 0"/><limit lower="0.1" upper="0.5" velocity="1" effort="1"/></joint>
    <joint name="tip" type="fixed"><parent link="lower"/><child link="tool"/><origin xyz="0 0 -0.2"/></joint>
    <joint name="hinge" type="revolute"><parent link="base"/><child link="flap"/><axis xyz="1 0 0"/>
      <limit lower="0.3" upper="2" velocity="1" effort="1"/></joint>
    <joint name="finger_left" type="prismatic"><parent link="tool"/><child link="left"/><axis xyz="0 1 0"/>
      <limit lower="0" upper="0.04" velocity="1" effort="1"/></joint>
    <joint name="finger_right" type="prismatic"><parent link="tool"/><child link="right"/><axis xyz="0 -1 0"/>
      <limit lower="0" upper="0.04" velocity="1" effort="1"/>)" +
                                               finger_extra + "</joint></robot>"));
}

ManipulatorDescription description() {
  ManipulatorDescription d;
  d.joints = {"shoulder", "slide"};
  d.tcp_link = "tool";
  d.finger_joints = {"finger_left", "finger_right"};
  d.finger_links = {"left", "right"};
  d.max_opening_m = 0.08;
  d.skip_self_collision = {{"base", "tool"}};
  return d;
}

/// What the constructor complains of.
std::string problem(const ManipulatorDescription& d, const RobotModel& model = arm(),
                    const Eigen::Isometry3d& X_WB = Eigen::Isometry3d::Identity()) {
  try {
    const Manipulator robot(model, d, X_WB, "arm.yaml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Manipulator, PutsAllLinksWhereTheJointsSay) {
  const Manipulator robot(arm(), description(), unevenPose(), "arm.yaml");
  const double q[] = {0.5, 0.3};
  std::vector<Eigen::Isometry3d> X_WL;
  robot.linkPoses(q, 0.06, X_WL);
  ASSERT_EQ(X_WL.size(), robot.model().links.size());
  const auto pose = [&](const char* link) {
    return Eigen::Isometry3d(unevenPose().inverse() *
                             X_WL[static_cast<std::size_t>(robot.model().linkIndex(link))]);
  };
  EXPECT_TRUE(pose("base").isApprox(Eigen::Isometry3d::Identity()));
  // The slide moves along the upper link's y axis, which the shoulder has turned.
  const Eigen::Vector3d along(-std::sin(0.5), std::cos(0.5), 0);
  EXPECT_TRUE(pose("lower").translation().isApprox(Eigen::Vector3d::UnitZ() + 0.3 * along));
  EXPECT_TRUE(pose("tool").translation().isApprox(0.8 * Eigen::Vector3d::UnitZ() + 0.3 * along));
  EXPECT_NEAR((pose("left").translation() - pose("right").translation()).norm(), 0.06, 1e-12);
  EXPECT_TRUE(robot.tcpPose(q).isApprox(unevenPose() * pose("tool")));
}

TEST(Manipulator, OtherJointsRestAtTheValueNearestToZero) {
  const Manipulator robot(arm(), description(), Eigen::Isometry3d::Identity(), "arm.yaml");
  const double q[] = {0, 0.2};
  std::vector<Eigen::Isometry3d> X_WL;
  robot.linkPoses(q, 0.0, X_WL);
  const Eigen::AngleAxisd turn(X_WL[static_cast<std::size_t>(robot.model().linkIndex("flap"))].linear());
  EXPECT_NEAR(turn.angle(), 0.3, 1e-12);
}

TEST(Manipulator, RestValuesAreKeptAndChecked) {
  auto d = description();
  d.rest = {{"hinge", 1.2}};
  const Manipulator robot(arm(), d, Eigen::Isometry3d::Identity(), "arm.yaml");
  const double q[] = {0, 0.2};
  std::vector<Eigen::Isometry3d> X_WL;
  robot.linkPoses(q, 0.0, X_WL);
  const Eigen::AngleAxisd turn(X_WL[static_cast<std::size_t>(robot.model().linkIndex("flap"))].linear());
  EXPECT_NEAR(turn.angle(), 1.2, 1e-12);
  for (const auto& [joint, value, complaint] :
       {std::tuple("hinge", 0.2, "arm.yaml: rest: joint 'hinge' at 0.2 is outside its limits, 0.3 to 2"),
        std::tuple("hinge", std::numeric_limits<double>::quiet_NaN(), "outside its limits"),
        std::tuple("tip", 0.0, "rest: joint 'tip' is fixed"), std::tuple("slide", 0.2, "does not rest"),
        std::tuple("finger_left", 0.0, "does not rest"), std::tuple("elbow", 0.0, "has no joint 'elbow'")}) {
    d.rest = {{joint, value}};
    EXPECT_THAT(problem(d), HasSubstr(complaint));
  }
}

TEST(Manipulator, LimitsAreInclusiveAndRefuseNonFiniteValues) {
  const Manipulator robot(arm(), description(), Eigen::Isometry3d::Identity(), "arm.yaml");
  EXPECT_TRUE(robot.withinLimits(robot.lower().data()));
  EXPECT_TRUE(robot.withinLimits(robot.upper().data()));
  for (const double bad : {2.0000001, -1.0000001, std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()}) {
    const double q[] = {bad, 0.2};
    EXPECT_FALSE(robot.withinLimits(q)) << bad;
  }
}

TEST(Manipulator, GoodDescriptionIsAccepted) { EXPECT_EQ(problem(description()), ""); }

TEST(Manipulator, NamesWhatDoesNotExist) {
  auto d = description();
  d.joints[1] = "elbow";
  EXPECT_EQ(problem(d), "arm.yaml: joints: robot 'arm' has no joint 'elbow'");
  d = description();
  d.tcp_link = "hook";
  EXPECT_EQ(problem(d), "arm.yaml: tcp_link: robot 'arm' has no link 'hook'");
  d = description();
  d.finger_joints[0] = "thumb";
  EXPECT_EQ(problem(d), "arm.yaml: finger_joints: robot 'arm' has no joint 'thumb'");
  d = description();
  d.finger_links[0] = "thumb";
  EXPECT_EQ(problem(d), "arm.yaml: finger_links: robot 'arm' has no link 'thumb'");
  d = description();
  d.skip_self_collision.push_back({"base", "hook"});
  EXPECT_EQ(problem(d), "arm.yaml: skip_self_collision: robot 'arm' has no link 'hook'");
}

TEST(Manipulator, RefusesJointsThatCannotBePlanned) {
  auto d = description();
  d.joints.push_back("tip");
  EXPECT_THAT(problem(d), HasSubstr("joint 'tip' is fixed"));
  d = description();
  d.joints.push_back("hinge");
  EXPECT_THAT(problem(d), HasSubstr("joint 'hinge' does not lie between the root and 'tool'"));
  d = description();
  d.joints.pop_back();
  EXPECT_THAT(problem(d), HasSubstr("joint 'slide' moves 'tool' but is not listed"));
  d = description();
  d.joints.clear();
  EXPECT_THAT(problem(d), HasSubstr("joints: no joint is listed"));
}

TEST(Manipulator, RefusesDuplicates) {
  auto d = description();
  d.joints.push_back("shoulder");
  EXPECT_THAT(problem(d), HasSubstr("joint 'shoulder' is listed twice"));
  d = description();
  d.finger_joints.push_back("finger_left");
  EXPECT_THAT(problem(d), HasSubstr("joint 'finger_left' is listed twice"));
  d = description();
  d.finger_links.push_back("left");
  EXPECT_THAT(problem(d), HasSubstr("link 'left' is listed twice"));
  d = description();
  d.finger_joints.push_back("slide");
  EXPECT_THAT(problem(d), HasSubstr("joint 'slide' is also one of the planned joints"));
  d = description();
  d.skip_self_collision.push_back({"base", "base"});
  EXPECT_THAT(problem(d), HasSubstr("link 'base' is paired with itself"));
}

TEST(Manipulator, RefusesOpeningsTheFingersCannotReach) {
  for (const double bad : {0.081, -0.01, std::numeric_limits<double>::quiet_NaN()}) {
    auto d = description();
    d.max_opening_m = bad;
    EXPECT_THAT(problem(d), HasSubstr("arm.yaml: max_opening_m: ")) << bad;
  }
  auto d = description();
  d.finger_joints.push_back("hinge");
  EXPECT_THAT(problem(d), HasSubstr("joint 'hinge' is not prismatic"));
}

TEST(Manipulator, RefusesABaseThatIsNotFinite) {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.translation().x() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(problem(description(), arm(), X_WB), "arm.yaml: robot_base: the pose is not finite");
}

TEST(Manipulator, MimicJointsAreUnderstoodBetweenFingersOnly) {
  const RobotModel model = arm(R"(<mimic joint="finger_left"/>)");
  EXPECT_EQ(problem(description(), model), "");
  auto d = description();
  d.finger_joints.pop_back();
  EXPECT_THAT(problem(d, model),
              HasSubstr("joint 'finger_right': mimics 'finger_left', which is supported only"));
  EXPECT_THAT(problem(description(), arm(R"(<mimic joint="slide"/>)")), HasSubstr("mimics 'slide'"));
}

}  // namespace
}  // namespace b4p
