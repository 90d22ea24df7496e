// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "experiments/result.h"
#include "experiments/scene.h"

namespace b4p::test {

/// Joints x, y, z (m), yaw and tilt (rad) carry a parallel gripper that points down. The hand's frame is at
/// (x, y, z), the TCP 5 cm below, finger tips 1 cm lower still. The base is a pillar at (-1, 0) with its top
/// at 0.42 m.
inline const char* const kGantryUrdf = R"(<?xml version="1.0"?>
<robot name="gantry">
  <link name="base">
    <collision><origin xyz="-1 0 0.21"/><geometry><box size="0.1 0.1 0.42"/></geometry></collision>
  </link>
  <link name="slide_x"/><link name="slide_y"/><link name="slide_z"/><link name="wrist"/>
  <link name="hand">
    <collision><origin xyz="0 0 -0.03"/><geometry><box size="0.06 0.2 0.06"/></geometry></collision>
  </link>
  <link name="left">
    <collision><origin xyz="0 0.01 0.03"/><geometry><box size="0.02 0.02 0.06"/></geometry></collision>
  </link>
  <link name="right">
    <collision><origin xyz="0 -0.01 0.03"/><geometry><box size="0.02 0.02 0.06"/></geometry></collision>
  </link>
  <link name="tcp"/>
  <joint name="x" type="prismatic">
    <parent link="base"/><child link="slide_x"/><axis xyz="1 0 0"/><limit lower="-2" upper="2"/>
  </joint>
  <joint name="y" type="prismatic">
    <parent link="slide_x"/><child link="slide_y"/><axis xyz="0 1 0"/><limit lower="-2" upper="2"/>
  </joint>
  <joint name="z" type="prismatic">
    <parent link="slide_y"/><child link="slide_z"/><axis xyz="0 0 1"/><limit lower="0" upper="2"/>
  </joint>
  <joint name="yaw" type="revolute">
    <parent link="slide_z"/><child link="wrist"/><axis xyz="0 0 1"/><limit lower="-3" upper="3"/>
  </joint>
  <joint name="tilt" type="revolute"><origin rpy="3.14159265358979323846 0 0"/>
    <parent link="wrist"/><child link="hand"/><axis xyz="1 0 0"/><limit lower="-1" upper="1"/>
  </joint>
  <joint name="finger_left" type="prismatic">
    <parent link="hand"/><child link="left"/><axis xyz="0 1 0"/><limit lower="0" upper="0.04"/>
  </joint>
  <joint name="finger_right" type="prismatic">
    <parent link="hand"/><child link="right"/><axis xyz="0 -1 0"/><limit lower="0" upper="0.04"/>
  </joint>
  <joint name="tcp_joint" type="fixed"><origin xyz="0 0 0.05"/>
    <parent link="hand"/><child link="tcp"/>
  </joint>
</robot>
)";

/// A folder of this process, gone when it ends.
class TemporaryFolder {
 public:
  TemporaryFolder() : path_(testing::TempDir() + "b4p_verification_" + std::to_string(getpid()) + "/") {
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

inline std::string temporaryFile(const std::string& name) {
  static const TemporaryFolder folder;
  return folder.path() + name;
}

inline std::string writeFile(const std::string& name, const std::string& content) {
  const std::string file = temporaryFile(name);
  std::ofstream(file, std::ios::binary) << content;
  return file;
}

inline Obstacle boxObstacle(const std::string& name, const Eigen::Vector3d& size,
                            const Eigen::Vector3d& centre) {
  Obstacle obstacle{name, {Box{size}, Eigen::Isometry3d::Identity()}};
  obstacle.shape.X_BS.translation() = centre;
  return obstacle;
}

/// A can on a table, to be carried over a wall 2 mm thin and put down upright.
inline Scene gantryScene() {
  Scene scene;
  scene.file = "/somewhere/over_the_wall.yaml";
  scene.name = "over_the_wall";
  scene.robot.file = "gantry.yaml";
  scene.robot.urdf_file = writeFile("gantry.urdf", kGantryUrdf);
  scene.robot.description.joints = {"x", "y", "z", "yaw", "tilt"};
  scene.robot.description.tcp_link = "tcp";
  scene.robot.description.finger_joints = {"finger_left", "finger_right"};
  scene.robot.description.finger_links = {"left", "right"};
  scene.robot.description.max_opening_m = 0.08;
  scene.obstacles = {boxObstacle("table", {1.9, 2, 0.1}, {0.05, 0, -0.05}),
                     boxObstacle("wall", {0.002, 1, 0.3}, {0.15, 0, 0.15})};
  scene.pickPlace().object_name = "can";
  scene.pickPlace().object = {{Box{{0.1, 0.06, 0.08}}, Eigen::Isometry3d::Identity()}};
  scene.pickPlace().X_WO_start.translation() << 0.5, 0.0, 0.045;
  scene.pickPlace().grasps.family = GraspFamily::kBox;
  scene.pickPlace().grasps.box_size_m << 0.1, 0.06, 0.08;
  scene.pickPlace().grasps.finger_depth_m = 0.05;
  scene.pickPlace().grasps.pad_clearance_m = 0.002;
  scene.pickPlace().placement.min_m << -0.5, 0.3, 0.04;
  scene.pickPlace().placement.max_m << 0.1, 0.9, 0.05;
  scene.pickPlace().placement.upright = true;
  scene.pickPlace().placement.yaw_min_rad = -0.5;
  scene.pickPlace().placement.yaw_max_rad = 0.5;
  scene.edge_step_m = 0.01;
  scene.pickPlace().contact_clearance_m = 0.005;
  return scene;
}

/// Lifts the can, carries it over the wall while turning it by 0.3 rad, puts it down.
inline PlanResult gantryResult() {
  PlanResult result;
  result.scene = "over_the_wall";
  result.planner = "b4p";
  result.parameters = {{"mode", "default"}, {"range", "0.1"}};
  result.seed = 18446744073709551557u;
  result.time_limit_s = 10.0;
  result.planning_time_s = 0.1;
  result.status = "Exact solution";
  result.solved = true;
  result.grasp_id = 3;
  result.grasp.X_OT.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();
  result.grasp.X_OT.translation() << 0.0, 0.0, 0.01;
  result.grasp.opening_m = 0.064;
  result.X_WO_pick.translation() << 0.5, 0.0, 0.045;
  result.X_WO_place.linear() = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  result.X_WO_place.translation() << -0.2, 0.6, 0.045;
  result.joint_names = {"x", "y", "z", "yaw", "tilt"};
  result.path = {{0.5, 0.0, 0.105, 0.0, 0.0},
                 {0.5, 0.0, 0.5, 0.0, 0.0},
                 {-0.2, 0.6, 0.5, 0.3, 0.0},
                 {-0.2, 0.6, 0.105, 0.3, 0.0}};
  return result;
}

}  // namespace b4p::test
