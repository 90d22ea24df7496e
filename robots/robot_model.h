// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "robots/shape.h"

namespace b4p {

enum class JointType { kFixed, kRevolute, kPrismatic };

/// Connects the parent link P to the child link C. With value v the pose of C in P is
/// X_PJ * (rotation by v rad about, or translation by v m along, `axis`).
struct Joint {
  std::string name;
  JointType type = JointType::kFixed;
  Eigen::Isometry3d X_PJ = Eigen::Isometry3d::Identity();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< unit vector in J
  double lower = 0.0;                               ///< rad or m; finite, lower < upper unless fixed
  double upper = 0.0;
  double max_velocity = std::numeric_limits<double>::infinity();  ///< rad/s or m/s; > 0 (URDF: 0 is none)
  int parent_link = -1;
  int child_link = -1;
  std::string mimicked_joint;  ///< joint whose value this one repeats (multiplier 1, offset 0); mostly empty
};

struct Link {
  std::string name;
  std::vector<PlacedShape> shapes;  ///< collision geometry, in the link's frame
  int parent_joint = -1;            ///< -1 for the root
};

/// A robot as its URDF describes it: a tree of links. Plain data, immutable once loaded, shared
/// by all threads. `links[0]` is the root; every joint comes after its parent's joint.
/// URDF `continuous` joints become revolute with the window [-2 pi, 2 pi].
struct RobotModel {
  std::string name;
  std::vector<Link> links;
  std::vector<Joint> joints;

  /// Index, or -1 when there is none of that name.
  int linkIndex(const std::string& link_name) const;
  int jointIndex(const std::string& joint_name) const;
};

/// Loads a URDF file through urdfdom and checks what urdfdom accepts silently.
///
/// Mesh files (STL, OBJ, DAE; `package://NAME/rest`, absolute or relative to the URDF; `scale`
/// honoured) become their convex hull. `package://NAME` is looked up upwards from the URDF's folder, then in
/// ROS_PACKAGE_PATH. A cylinder with two equal spheres at its ends becomes one capsule.
///
/// @throws InputError naming file, link or joint and value: unreadable or malformed XML, leftover xacro, a
///   link that is its own ancestor, several roots, limits missing, reversed or non-finite, a zero or
///   non-finite axis, non-finite origins, sizes that are not positive, an unknown shape, a missing or empty
///   mesh, fewer shapes loaded than declared, joint types other than fixed, revolute, continuous, prismatic.
///   Non-unit axes are normalised. A mimic joint may only repeat the other's value.
RobotModel loadUrdf(const std::string& file);

}  // namespace b4p
