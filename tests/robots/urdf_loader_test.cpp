// SPDX-License-Identifier: BSD-3-Clause
#include "robots/robot_model.h"

#include <cmath>
#include <limits>
#include <locale>
#include <thread>

#include <gtest/gtest.h>

#include "robots/input_error.h"
#include "robots/temporary_folder.h"

// Promises: what a good URDF says is what the model holds; the root comes first and parents before children;
// nothing is printed; the locale does not matter; several threads may load at once.

namespace b4p {
namespace {

constexpr double kPi = 3.14159265358979323846;

const char* const kGood = R"(<?xml version="1.0"?>
<robot name="good" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <!-- children come before parents here -->
  <joint name="turn" type="revolute"><parent link="base"/><child link="arm"/>
    <origin xyz="0.1 0.2 0.3" rpy="0.1 -0.2 0.3"/><axis xyz="0 3 4"/>
    <limit lower="-1.5" upper="2.5" velocity="0.7" effort="1"/></joint>
  <joint name="spin" type="continuous"><parent link="arm"/><child link="wheel"/><axis xyz="0 0 -2"/></joint>
  <joint name="slide" type="prismatic"><parent link="wheel"/><child link="sled"/>
    <limit lower="0" upper="0.25" velocity="0" effort="0"/></joint>
  <joint name="weld" type="fixed"><parent link="base"/><child link="plate"/><origin xyz="0 0 -1"/></joint>
  <link name="sled"/>
  <link name="wheel"><collision><origin xyz="0 0 0.1" rpy="1.5707963267948966 0 0"/>
    <geometry><cylinder radius="0.2" length="0.05"/></geometry></collision></link>
  <link name="plate"><visual><geometry><box size="1 1 1"/></geometry></visual></link>
  <link name="arm">
    <collision><geometry><box size="0.1 0.2 0.3"/></geometry></collision>
    <collision><origin xyz="1e-1 +0.2 .3"/><geometry><sphere radius="0.04"/></geometry></collision></link>
  <link name="base"/>
</robot>)";

class UrdfLoader : public testing::Test {
 protected:
  const Link& link(const std::string& name) const {
    return model_.links.at(static_cast<std::size_t>(model_.linkIndex(name)));
  }
  const Joint& joint(const std::string& name) const {
    return model_.joints.at(static_cast<std::size_t>(model_.jointIndex(name)));
  }

  TemporaryFolder folder_;
  std::string file_ = folder_.write("good.urdf", kGood);
  RobotModel model_ = loadUrdf(file_);
};

TEST_F(UrdfLoader, RootComesFirstAndParentsBeforeChildren) {
  EXPECT_EQ(model_.name, "good");
  ASSERT_EQ(model_.links.size(), 5u);
  ASSERT_EQ(model_.joints.size(), 4u);
  EXPECT_EQ(model_.links[0].name, "base");
  EXPECT_EQ(model_.links[0].parent_joint, -1);
  for (std::size_t j = 0; j < model_.joints.size(); ++j) {
    const Joint& joint = model_.joints[j];
    EXPECT_EQ(model_.links[static_cast<std::size_t>(joint.child_link)].parent_joint, static_cast<int>(j));
    EXPECT_LT(model_.links[static_cast<std::size_t>(joint.parent_link)].parent_joint, static_cast<int>(j));
  }
  EXPECT_EQ(joint("spin").parent_link, model_.linkIndex("arm"));
  EXPECT_EQ(joint("spin").child_link, model_.linkIndex("wheel"));
}

TEST_F(UrdfLoader, UnknownNamesHaveNoIndex) {
  EXPECT_EQ(model_.linkIndex("turn"), -1);
  EXPECT_EQ(model_.jointIndex("base"), -1);
}

TEST_F(UrdfLoader, JointsHoldWhatTheTextSays) {
  EXPECT_EQ(joint("turn").type, JointType::kRevolute);
  EXPECT_EQ(joint("turn").lower, -1.5);
  EXPECT_EQ(joint("turn").upper, 2.5);
  EXPECT_EQ(joint("turn").max_velocity, 0.7);
  Eigen::Isometry3d X_PJ = Eigen::Isometry3d::Identity();
  X_PJ.translate(Eigen::Vector3d(0.1, 0.2, 0.3));
  X_PJ.rotate(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()) *
              Eigen::AngleAxisd(-0.2, Eigen::Vector3d::UnitY()) *
              Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()));
  EXPECT_TRUE(joint("turn").X_PJ.isApprox(X_PJ, 1e-12));
  EXPECT_EQ(joint("slide").type, JointType::kPrismatic);
  EXPECT_EQ(joint("weld").type, JointType::kFixed);
  EXPECT_EQ(joint("weld").X_PJ.translation(), Eigen::Vector3d(0, 0, -1));
}

TEST_F(UrdfLoader, AxesBecomeUnitVectors) {
  EXPECT_TRUE(joint("turn").axis.isApprox(Eigen::Vector3d(0, 0.6, 0.8)));
  EXPECT_TRUE(joint("spin").axis.isApprox(-Eigen::Vector3d::UnitZ()));
  EXPECT_TRUE(joint("slide").axis.isApprox(Eigen::Vector3d::UnitX())) << "URDF's default";
}

TEST_F(UrdfLoader, ContinuousJointsHaveAWindowOfTwoTurns) {
  EXPECT_EQ(joint("spin").type, JointType::kRevolute);
  EXPECT_DOUBLE_EQ(joint("spin").lower, -2 * kPi);
  EXPECT_DOUBLE_EQ(joint("spin").upper, 2 * kPi);
}

TEST_F(UrdfLoader, VelocityThatIsNotKnownDoesNotLimit) {
  EXPECT_EQ(joint("spin").max_velocity, std::numeric_limits<double>::infinity());
  EXPECT_EQ(joint("slide").max_velocity, std::numeric_limits<double>::infinity());
}

TEST_F(UrdfLoader, CollisionShapesAreLoadedAndVisualsAreNot) {
  EXPECT_TRUE(link("plate").shapes.empty());
  ASSERT_EQ(link("arm").shapes.size(), 2u);
  EXPECT_EQ(std::get<Box>(link("arm").shapes[0].shape).size, Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(std::get<Sphere>(link("arm").shapes[1].shape).radius, 0.04);
  EXPECT_EQ(link("arm").shapes[1].X_BS.translation(), Eigen::Vector3d(0.1, 0.2, 0.3));
  ASSERT_EQ(link("wheel").shapes.size(), 1u);
  const PlacedShape& wheel = link("wheel").shapes[0];
  EXPECT_EQ(std::get<Cylinder>(wheel.shape).radius, 0.2);
  EXPECT_EQ(std::get<Cylinder>(wheel.shape).length, 0.05);
  EXPECT_TRUE(wheel.X_BS.linear().col(2).isApprox(-Eigen::Vector3d::UnitY()));
}

TEST_F(UrdfLoader, PrintsNothingEvenWhenUrdfdomComplains) {
  // Only urdfdom looks at safety controllers.
  const std::string refused =
      folder_.write("refused.urdf", R"(<robot name="r"><link name="a"/><link name="b"/>
    <joint name="j" type="fixed"><parent link="a"/><child link="b"/><safety_controller/></joint></robot>)");
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  std::string problem;
  try {
    loadUrdf(file_);
    loadUrdf(refused);
  } catch (const InputError& error) {
    problem = error.what();
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(problem.rfind(refused + ": urdfdom refuses it: ", 0), 0u) << problem;
  EXPECT_EQ(problem.find('\n'), std::string::npos);
}

TEST_F(UrdfLoader, SeveralThreadsLoadAtOnce) {
  std::vector<std::thread> threads;
  std::vector<int> wrong(4, 0);
  for (int& count : wrong)
    threads.emplace_back([this, &count] {
      for (int i = 0; i < 50; ++i)
        if (loadUrdf(file_).links.size() != 5) ++count;
    });
  for (auto& thread : threads) thread.join();
  for (const int count : wrong) EXPECT_EQ(count, 0);
}

/// Numbers as people write them in many countries.
class DecimalComma : public std::numpunct<char> {
 protected:
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(UrdfLoaderLocale, DoesNotMatter) {
  const TemporaryFolder folder;
  const std::string good = folder.write("good.urdf", kGood);
  const std::string bad = folder.write("bad.urdf", R"(<robot name="r"><link name="a"><collision><geometry>
    <sphere radius="0,5"/></geometry></collision></link></robot>)");
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
  RobotModel model;
  EXPECT_NO_THROW(model = loadUrdf(good));
  EXPECT_THROW(loadUrdf(bad), InputError);
  std::locale::global(before);
  ASSERT_GE(model.jointIndex("turn"), 0);
  EXPECT_EQ(model.joints.at(static_cast<std::size_t>(model.jointIndex("turn"))).lower, -1.5);
  EXPECT_EQ(model.joints.at(static_cast<std::size_t>(model.jointIndex("turn"))).max_velocity, 0.7);
}

}  // namespace
}  // namespace b4p
