// SPDX-License-Identifier: BSD-3-Clause
// Promises: poses agree with hand-computed ones and with the published check value of the Panda; the motion
// bound holds; what a URDF cannot mean is refused by name.
#include "experiments/verification/kinematics.h"

#include <cmath>
#include <filesystem>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robots/input_error.h"
#include "verification/gantry.h"

namespace b4p::verification {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using testing::HasSubstr;

constexpr double kPi = 3.14159265358979323846;

/// The arm's joints as the manufacturer gives them: xyz, rpy, limits.
std::string pandaUrdf() {
  struct Row {
    const char *xyz, *rpy, *lower, *upper;
  };
  const std::string quarter = "1.5707963267948966";
  const std::string back = "-" + quarter + " 0 0", forth = quarter + " 0 0";
  const Row rows[] = {
      {"0 0 .333", "0 0 0", "-2.8973", "2.8973"},           {"0 0 0", back.c_str(), "-1.7628", "1.7628"},
      {"0 -.316 0", forth.c_str(), "-2.8973", "2.8973"},    {".0825 0 0", forth.c_str(), "-3.0718", "-.0698"},
      {"-.0825 .384 0", back.c_str(), "-2.8973", "2.8973"}, {"0 0 0", forth.c_str(), "-.0175", "3.7525"},
      {".088 0 0", forth.c_str(), "-2.8973", "2.8973"}};
  std::string xml = "<robot name='panda'><link name='l0'/>";
  int i = 0;
  for (const Row& row : rows) {
    const std::string parent = "l" + std::to_string(i), child = "l" + std::to_string(++i);
    xml += "<link name='" + child + "'/><joint name='j" + std::to_string(i) +
           "' type='revolute'><parent link='" + parent + "'/><child link='" + child + "'/><origin xyz='" +
           row.xyz + "' rpy='" + row.rpy + "'/><axis xyz='0 0 1'/><limit lower='" + row.lower + "' upper='" +
           row.upper + "'/></joint>";
  }
  return xml +
         "<link name='tcp'/><joint name='hand' type='fixed'><parent link='l7'/><child link='tcp'/>"
         "<origin xyz='0 0 .2104' rpy='0 0 -.7853981633974483'/></joint></robot>";
}

ManipulatorDescription arm(const std::string& joint_prefix, const std::string& tcp) {
  ManipulatorDescription description;
  for (int i = 1; i <= 7; ++i) description.joints.push_back(joint_prefix + std::to_string(i));
  description.tcp_link = tcp;
  return description;
}

void expectPandaCheckValue(const Kinematics& panda) {
  Eigen::VectorXd q(7);
  q << 0, -.785, 0, -2.356, 0, 1.571, .785;
  const Vector3d p = panda.linkPoses(q, 0.0)[panda.tcpLink()].translation();
  EXPECT_LT((p - Vector3d(.30702, 0, .48687)).norm(), 2e-5) << p.transpose();
}

Kinematics gantry(const Isometry3d& X_WB = Isometry3d::Identity()) {
  const Scene scene = test::gantryScene();
  return Kinematics(scene.robot.urdf_file, scene.robot.description, X_WB);
}

TEST(KinematicsTest, PandaReachesItsCheckValue) {
  expectPandaCheckValue(
      Kinematics(test::writeFile("panda.urdf", pandaUrdf()), arm("j", "tcp"), Isometry3d::Identity()));
}

TEST(KinematicsTest, ShippedPandaReachesItsCheckValue) {
  ASSERT_TRUE(std::filesystem::exists(B4P_PANDA_URDF));
  expectPandaCheckValue(Kinematics(B4P_PANDA_URDF, arm("panda_joint", "panda_tcp"), Isometry3d::Identity()));
}

TEST(KinematicsTest, GantryStandsWhereHandComputationSays) {
  Isometry3d X_WB = Isometry3d::Identity();
  X_WB.translation() << 10, 20, 30;
  X_WB.linear() = Eigen::AngleAxisd(kPi / 2, Vector3d::UnitZ()).toRotationMatrix();
  const Kinematics robot = gantry(X_WB);
  Eigen::VectorXd q(5);
  q << 1, 2, 0.5, kPi / 2, 0;
  const auto X_WL = robot.linkPoses(q, 0.06);
  // The base's quarter turn maps (1, 2) to (-2, 1); half a turn in all maps the hand's y to -y, its tilt by
  // pi back to y.
  const auto at = [&](const char* link) { return X_WL[robot.tree().linkIndex(link)]; };
  EXPECT_TRUE(at("hand").translation().isApprox(Vector3d(8, 21, 30.5), 1e-12));
  EXPECT_TRUE(at("tcp").translation().isApprox(Vector3d(8, 21, 30.45), 1e-12));
  EXPECT_TRUE(at("left").translation().isApprox(Vector3d(8, 21.03, 30.5), 1e-12));
  EXPECT_TRUE(at("right").translation().isApprox(Vector3d(8, 20.97, 30.5), 1e-12));
  EXPECT_TRUE(at("hand").linear().isApprox(Eigen::Matrix3d(Vector3d(-1, 1, -1).asDiagonal()), 1e-12));
}

TEST(KinematicsTest, RollPitchYawTurnAboutFixedAxesInThatOrder) {
  const UrdfTree tree = readUrdf(test::writeFile(
      "rpy.urdf",
      "<robot name='r'><link name='a'/><link name='b'/><joint name='j' type='fixed'><parent link='a'/>"
      "<child link='b'/><origin xyz='1 2 3' rpy='1.5707963267948966 0 "
      "1.5707963267948966'/></joint></robot>"));
  // Roll takes y to z; yaw leaves it. Roll takes z to -y; yaw takes that to x.
  EXPECT_TRUE((tree.joints[0].X_PJ * Vector3d(0, 1, 0)).isApprox(Vector3d(1, 2, 4), 1e-12));
  EXPECT_TRUE((tree.joints[0].X_PJ * Vector3d(0, 0, 1)).isApprox(Vector3d(2, 2, 3), 1e-12));
}

/// A crane: it turns, and its boom slides out from there.
Kinematics crane() {
  ManipulatorDescription description;
  description.joints = {"turn", "boom"};
  description.tcp_link = "hook";
  return Kinematics(
      test::writeFile("crane.urdf",
                      "<robot name='crane'><link name='base'/><link name='cab'/><link name='hook'/>"
                      "<joint name='turn' type='revolute'><parent link='base'/><child link='cab'/>"
                      "<axis xyz='0 0 1'/><limit lower='-3' upper='3'/></joint>"
                      "<joint name='boom' type='prismatic'><parent link='cab'/><child link='hook'/>"
                      "<axis xyz='1 0 0'/><limit lower='0' upper='2'/></joint></robot>"),
      description, Isometry3d::Identity());
}

TEST(KinematicsTest, NoPointMovesFartherThanTheBound) {
  const Kinematics panda(test::writeFile("panda.urdf", pandaUrdf()), arm("j", "tcp"), Isometry3d::Identity());
  const Kinematics slider = gantry(), turner = crane();
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const Kinematics* robot : {&panda, &slider, &turner})
    for (int i = 0; i < 3000; ++i) {
      Eigen::VectorXd q1(robot->dof()), q2(robot->dof());
      for (int j = 0; j < robot->dof(); ++j) {
        const UrdfJoint& joint = robot->plannedJoint(j);
        q1[j] = joint.lower + unit(random) * (joint.upper - joint.lower);
        q2[j] = joint.lower + unit(random) * (joint.upper - joint.lower);
      }
      const std::size_t link =
          std::uniform_int_distribution<std::size_t>(0, robot->tree().links.size() - 1)(random);
      const Vector3d p_L = 0.3 * Vector3d(unit(random), unit(random), unit(random));
      const double moved =
          (robot->linkPoses(q1, 0.04)[link] * p_L - robot->linkPoses(q2, 0.04)[link] * p_L).norm();
      const Eigen::VectorXd bound = robot->motionPerUnit(static_cast<int>(link), p_L.norm());
      EXPECT_LE(moved, bound.dot((q2 - q1).cwiseAbs()) + 1e-12);
    }
}

TEST(KinematicsTest, ShapesAreReadWithTheirOriginsAndSizes) {
  const UrdfTree tree = readUrdf(test::writeFile(
      "shapes.urdf",
      "<robot name='r'><link name='a'><visual><geometry><box size='9 9 9'/></geometry></visual>"
      "<collision><origin xyz='1 0 0'/><geometry><box size='.2 .4 .6'/></geometry></collision>"
      "<collision><geometry><sphere radius='.5'/></geometry></collision>"
      "<collision><geometry><cylinder radius='.3' length='.8'/></geometry></collision></link></robot>"));
  const auto& bodies = tree.links.at(0).bodies;
  ASSERT_EQ(bodies.size(), 3u);
  EXPECT_EQ(bodies[0].X_LS.translation(), Vector3d(1, 0, 0));
  EXPECT_TRUE(bodies[0].body.support({1, 1, -1}).isApprox(Vector3d(.1, .2, -.3)));
  EXPECT_DOUBLE_EQ(bodies[1].body.margin(), 0.5);
  EXPECT_TRUE(bodies[2].body.support({1, 0, 1}).isApprox(Vector3d(.3, 0, .4)));
}

TEST(KinematicsTest, MeshesStandForTheirScaledHull) {
  namespace fs = std::filesystem;
  const fs::path folder = test::temporaryFile("some_package");
  fs::create_directories(folder / "meshes");
  fs::create_directories(folder / "urdf");
  std::ofstream(folder / "meshes" / "wedge.obj")
      << "v 0 0 0\nv 1000 0 0\nv 0 2000 0\nv 0 0 3000\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  const auto load = [&](const std::string& reference) {
    std::ofstream(folder / "urdf" / "wedge.urdf")
        << "<robot name='r'><link name='a'><collision><geometry><mesh scale='.001 .001 .001' filename='"
        << reference << "'/></geometry></collision></link></robot>";
    return readUrdf((folder / "urdf" / "wedge.urdf").string()).links.at(0).bodies.at(0).body;
  };
  for (const std::string& reference :
       {"package://" + folder.filename().string() + "/meshes/wedge.obj", std::string("../meshes/wedge.obj"),
        (folder / "meshes/wedge.obj").string(), "file://" + (folder / "meshes/wedge.obj").string()}) {
    const ConvexBody body = load(reference);
    EXPECT_TRUE(body.support({1, 0, 0}).isApprox(Vector3d(1, 0, 0), 1e-6)) << reference;
    EXPECT_TRUE(body.support({0, 0, 1}).isApprox(Vector3d(0, 0, 3), 1e-6)) << reference;
  }
  EXPECT_THROW(load("package://another_package/meshes/wedge.obj"), InputError);
  EXPECT_THROW(load("missing.obj"), InputError);
  fs::remove_all(folder);
}

void expectRefused(const std::string& xml, const std::string& part_of_message) {
  try {
    readUrdf(test::writeFile("bad.urdf", xml));
    FAIL() << xml << " was accepted";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr(part_of_message));
    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
  }
}

TEST(UrdfReaderTest, RefusesWhatAUrdfCannotMean) {
  const std::string start = "<robot name='r'><link name='a'/><link name='b'/>";
  const auto joint = [&](const std::string& type, const std::string& inside) {
    return start + "<joint name='j' type='" + type + "'><parent link='a'/><child link='b'/>" + inside +
           "</joint></robot>";
  };
  const auto shape = [](const std::string& geometry) {
    return "<robot name='r'><link name='a'><collision><geometry>" + geometry +
           "</geometry></collision></link></robot>";
  };
  expectRefused("<robot name='r'><link", "line");
  expectRefused("<sdf/>", "<robot>");
  expectRefused(start + "</robot>", "2 root links");
  expectRefused(joint("revolute", "<axis xyz='0 0 1'/>"), "<limit>");
  expectRefused(joint("revolute", "<axis xyz='0 0 0'/><limit lower='0' upper='1'/>"), "axis is zero");
  expectRefused(joint("revolute", "<limit lower='1' upper='0'/>"), "not below");
  expectRefused(joint("prismatic", "<limit lower='nan' upper='1'/>"), "lower=\"nan\"");
  expectRefused(joint("floating", ""), "floating");
  expectRefused(joint("fixed", "<origin xyz='0 0'/>"), "xyz=\"0 0\"");
  expectRefused(joint("fixed", "<origin xyz='0 0 ${h}'/>"), "${h}");
  expectRefused(start + "<joint name='j' type='fixed'><parent link='c'/><child link='b'/></joint></robot>",
                "'c'");
  expectRefused(start + "<joint name='j' type='fixed'><parent link='b'/><child link='b'/></joint></robot>",
                "loop");
  expectRefused(shape("<box size='1 1 nan'/>"), "1 1 nan");
  expectRefused(shape("<box size='1 -1 1'/>"), "1 -1 1");
  expectRefused(shape("<sphere radius='0'/>"), "radius=\"0\"");
  expectRefused(shape("<cylinder radius='1'/>"), "length");
  expectRefused(shape("<cone radius='1'/>"), "cone");
  expectRefused(shape(""), "one shape");
  expectRefused(shape("<mesh filename='none.stl'/>"), "none.stl");
}

TEST(KinematicsTest, RefusesNamesThatTheRobotDoesNotHave) {
  Scene scene = test::gantryScene();
  scene.robot.description.tcp_link = "nowhere";
  EXPECT_THROW(Kinematics(scene.robot.urdf_file, scene.robot.description, scene.X_WB), InputError);
  scene = test::gantryScene();
  scene.robot.description.joints[0] = "nowhere";
  EXPECT_THROW(Kinematics(scene.robot.urdf_file, scene.robot.description, scene.X_WB), InputError);
}

}  // namespace
}  // namespace b4p::verification
