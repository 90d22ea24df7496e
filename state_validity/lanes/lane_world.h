// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "state_validity/lanes/obstacle_groups.h"

namespace b4p::lanes {

/// Configurations that are looked at together, whatever the width of the processor's registers.
inline constexpr int kLanes = 16;

/// A pose as single-precision numbers: rotation row by row, then the translation (m).
struct LanePose {
  float r[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  float p[3] = {0, 0, 0};
};

/// A planned joint; its frame moves about (or along) its own z.
struct LaneJoint {
  int parent = -1;       ///< index of the joint that carries it; -1: the world
  int q_index = 0;       ///< place of its value in q
  bool revolute = true;  ///< else prismatic
  LanePose in_parent;    ///< before its own motion, in its parent's moved frame
};

enum class LaneKind : std::uint8_t { kSegment, kBox, kCylinder, kMesh };

/// Faces and vertices of a convex mesh about the middle of its bounding box.
struct LaneMesh {
  std::vector<float> nx, ny, nz, offset;  ///< face f: n . x <= offset
  std::vector<float> x, y, z;
};

/// A convex solid, fixed to a joint's frame or to the world. Its own frame has the origin at its middle.
struct LaneBody {
  LaneKind kind = LaneKind::kSegment;
  int joint = -1;  ///< -1: the world
  LanePose in_joint;
  float half[3] = {0, 0, 0};             ///< of the bounding box; a segment's and a cylinder's axis is z
  float radius = 0;                      ///< of the ball that rounds a segment; 0 for the others
  float size = 0;                        ///< largest distance of any point from the middle
  float margin = 0;                      ///< bound of what rounding does to the place of any point (m)
  std::shared_ptr<const LaneMesh> mesh;  ///< kMesh, unless it has too many faces: then its box stands for it
};

/// Two bodies that must not overlap, neither of them an obstacle.
struct LanePair {
  int a = 0;
  int b = 0;
  int index = 0;  ///< among all such pairs
};

/// What stands still, shared by all grasps. Bodies are numbered as in CollisionPieces.
struct LaneWorld {
  std::vector<LaneJoint> joints;  ///< parents first
  int moving_end = 0;             ///< bodies from here on stand still
  int obstacle_begin = 0;
  std::vector<LaneBody> still;  ///< bodies moving_end and up
  LaneBoxes obstacles;          ///< their bounding boxes
  ObstacleGroups obstacle_groups;
  float clear_m = 0;  ///< bodies farther apart than this count as apart

  const LaneBody& stillBody(int i) const { return still[static_cast<std::size_t>(i - moving_end)]; }
  int bodyCount() const { return moving_end + static_cast<int>(still.size()); }
};

/// What moves with one grasp, or empty-handed.
struct LaneRobot {
  std::vector<LaneBody> moving;
  std::vector<std::uint8_t> meets_obstacles;  ///< by moving body
  std::vector<LanePair> pairs;
};

}  // namespace b4p::lanes
