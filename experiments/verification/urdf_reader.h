// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "experiments/verification/convex_body.h"

namespace b4p::verification {

enum class UrdfJointType { kFixed, kRevolute, kPrismatic };

/// With value v, the child link's frame in the parent's is X_PJ * (turn by v rad about, or shift by v m
/// along, axis).
struct UrdfJoint {
  std::string name;
  UrdfJointType type = UrdfJointType::kFixed;
  Eigen::Isometry3d X_PJ = Eigen::Isometry3d::Identity();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
  double lower = 0.0, upper = 0.0;  ///< rad or m
  int parent_link = -1, child_link = -1;
};

struct UrdfLink {
  std::string name;
  int parent_joint = -1;  ///< -1 for the root
  std::vector<PlacedBody> bodies;
};

/// What of a URDF file bears on where a robot's solid parts are.
struct UrdfTree {
  std::vector<UrdfLink> links;
  std::vector<UrdfJoint> joints;
  std::vector<int> root_first;  ///< all link indices, each after its parent
  /// Index of the link or joint of that name, -1 if there is none.
  int linkIndex(const std::string& name) const;
  int jointIndex(const std::string& name) const;
};

/// Reads a URDF with an XML parser alone. Joints of type `continuous` may turn by a full turn either way;
/// meshes stand for the convex hull of their points.
/// @throws InputError for malformed XML, elements missing or not understood, numbers that are not finite or
///   out of range, links that do not form one tree.
UrdfTree readUrdf(const std::string& file);

}  // namespace b4p::verification
