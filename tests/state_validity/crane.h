// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "robots/manipulator.h"
#include "state_validity/collision_checker.h"

namespace b4p::testing {

using CraneConfiguration = std::array<double, 4>;

inline PlacedShape placedAt(Shape shape, const Eigen::Vector3d& position) {
  return {std::move(shape), Eigen::Isometry3d(Eigen::Translation3d(position))};
}

/// A robot that puts one shape wherever a test wants it: q = (x, y, z, yaw) is the pose of its link "tool".
/// Links: base -x-> rail -y-> bridge -z-> column -yaw-> tool, and tool -> left, right (fingers that open
/// along y, up to 0.2 m). Travels 3 m each way and turns by pi. The TCP is the tool's origin.
class Crane {
 public:
  Crane() {
    model_.name = "crane";
    model_.links.push_back({"base", {}, -1});
    joint("x", JointType::kPrismatic, Eigen::Vector3d::UnitX(), "base", "rail", kReach_m);
    joint("y", JointType::kPrismatic, Eigen::Vector3d::UnitY(), "rail", "bridge", kReach_m);
    joint("z", JointType::kPrismatic, Eigen::Vector3d::UnitZ(), "bridge", "column", kReach_m);
    joint("yaw", JointType::kRevolute, Eigen::Vector3d::UnitZ(), "column", "tool", 3.14159);
    joint("open_left", JointType::kPrismatic, Eigen::Vector3d::UnitY(), "tool", "left", 0.1);
    joint("open_right", JointType::kPrismatic, -Eigen::Vector3d::UnitY(), "tool", "right", 0.1);
    description_ = {
        {"x", "y", "z", "yaw"}, "tool", {"open_left", "open_right"}, {"left", "right"}, 0.2, {}, {}};
  }

  Crane& with(const std::string& link, PlacedShape shape) {
    model_.links[static_cast<std::size_t>(model_.linkIndex(link))].shapes.push_back(std::move(shape));
    return *this;
  }

  Crane& with(const std::string& link, Shape shape) {
    return with(link, placedAt(std::move(shape), Eigen::Vector3d::Zero()));
  }

  Crane& allow(const std::string& link_a, const std::string& link_b) {
    description_.skip_self_collision.emplace_back(link_a, link_b);
    return *this;
  }

  std::shared_ptr<const Manipulator> build() const {
    return std::make_shared<const Manipulator>(model_, description_, Eigen::Isometry3d::Identity(),
                                               "crane.h");
  }

  static constexpr double kReach_m = 3.0;

 private:
  void joint(const std::string& name, JointType type, const Eigen::Vector3d& axis, const std::string& parent,
             const std::string& child, double reach) {
    Joint joint;
    joint.name = name;
    joint.type = type;
    joint.axis = axis;
    joint.lower = -reach;
    joint.upper = reach;
    joint.parent_link = model_.linkIndex(parent);
    joint.child_link = static_cast<int>(model_.links.size());
    model_.links.push_back({child, {}, static_cast<int>(model_.joints.size())});
    model_.joints.push_back(joint);
  }

  RobotModel model_;
  ManipulatorDescription description_;
};

inline CraneConfiguration randomCrane(std::mt19937_64& random, double reach_m = Crane::kReach_m) {
  std::uniform_real_distribution<> place(-reach_m, reach_m), yaw(-3.1, 3.1);
  return {place(random), place(random), place(random), yaw(random)};
}

/// A rectangular block as a mesh.
inline std::shared_ptr<const ConvexMesh> blockMesh(const Eigen::Vector3d& size) {
  std::vector<Eigen::Vector3d> corners;
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      for (const double z : {-0.5, 0.5}) corners.push_back(Eigen::Vector3d(x, y, z).cwiseProduct(size));
  return convexHull(corners);
}

/// One of each type, every one reaching exactly 0.1 m along +x from its origin.
struct NamedShape {
  std::string name;
  Shape shape;
};
inline constexpr double kShapeReach_m = 0.1;
inline std::vector<NamedShape> oneOfEach() {
  return {{"box", Box{{0.2, 0.3, 0.16}}},
          {"sphere", Sphere{0.1}},
          {"cylinder", Cylinder{0.1, 0.24}},
          {"capsule", Capsule{0.1, 0.2}},
          {"mesh", blockMesh({0.2, 0.3, 0.16})}};
}

/// The object's origin at the TCP plus `offset` (in the TCP's frame).
inline Grasp graspWithObjectAt(const Eigen::Vector3d& offset, double opening_m = 0.1) {
  Grasp grasp;
  grasp.X_OT = Eigen::Isometry3d(Eigen::Translation3d(-offset));
  grasp.opening_m = opening_m;
  return grasp;
}

}  // namespace b4p::testing
