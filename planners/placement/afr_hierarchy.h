// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "planners/placement/placement_world.h"

namespace b4p {

/// Part of a contact region: a run of its cells in CellTree::order().
struct CellPatch {
  int begin = 0, end = 0;
  std::vector<int> children;  ///< numbers of patches; empty for a single cell
  Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
  double radius_m = 0.0;  ///< of a circle about the centre around all its cells
};

/// A contact region cut at the middle of its bounding box in x and y, again and again, down to cells. Patch 0
/// is the whole region.
class CellTree {
 public:
  explicit CellTree(const ContactRegion& region);

  const std::vector<CellPatch>& patches() const { return patches_; }
  const CellPatch& patch(int number) const { return patches_[static_cast<std::size_t>(number)]; }
  const std::vector<int>& order() const { return order_; }  ///< numbers of the region's cells

  /// The cell that contains a point, or -1.
  int cellAt(const Eigen::Vector2d& p_W) const;

  const ContactRegion& region() const { return *region_; }

 private:
  int addPatch(int begin, int end);
  void split(int patch);

  const ContactRegion* region_;
  std::vector<int> order_;
  std::vector<CellPatch> patches_;
};

/// A node of the AFR hierarchy (paper, Section IV-C1): at depth 1 the arm is chosen, at 2 the face, at 3 the
/// region; deeper ones have a part of the region and of the full turn.
struct AfrNode {
  int depth = 0;
  GraspId arm = kNoGrasp;
  int face = -1;
  int region = -1;
  int patch = 0;
  int angle_depth = 0;       ///< how often the full turn has been split in four
  double angle_low_rad = 0;  ///< the node's angles are [low, low + angleWidth())
};

/// The hierarchy itself: nodes are values that are made when asked for.
class AfrHierarchy {
 public:
  static constexpr int kFullyChosen = 3;  ///< depth from which on a node can be sampled
  static constexpr int kAngleDepth = 4;   ///< four parts, four times: 0.0245 rad

  /// @param world  has to outlive this object
  explicit AfrHierarchy(const PlacementWorld& world);

  int childCount(const AfrNode& node) const;  ///< 0 for a leaf, or where the world has nothing to choose
  AfrNode child(const AfrNode& node, int number) const;

  /// The child that a placement belongs to, or -1.
  int childOf(const AfrNode& node, const Placement& placement) const;

  /// A placement drawn uniformly from a fully chosen node.
  template <class Random>
  Placement sample(const AfrNode& node, Random& random) const;

  /// The node's middle, and how far its placements are from it.
  Placement middle(const AfrNode& node) const;
  double radius_m(const AfrNode& node) const { return patchOf(node).radius_m; }
  static double angleWidth(const AfrNode& node);

  const PlacementWorld& world() const { return world_; }
  const std::vector<CellTree>& trees() const { return trees_; }

 private:
  const CellTree& tree(const AfrNode& node) const { return trees_[static_cast<std::size_t>(node.region)]; }
  const CellPatch& patchOf(const AfrNode& node) const { return tree(node).patch(node.patch); }
  Placement at(const AfrNode& node, int cell, double share_x, double share_y, double share_angle) const;

  const PlacementWorld& world_;
  std::vector<CellTree> trees_;
};

/// A number in [0, 1), the same on every platform.
template <class Random>
double unitDraw(Random& random) {
  constexpr double kUnit = 1.0 / 9007199254740992.0;  // 2^-53
  return static_cast<double>(random() >> 11) * kUnit;
}

template <class Random>
int indexDraw(Random& random, int count) {
  return static_cast<int>(unitDraw(random) * count);
}

template <class Random>
Placement AfrHierarchy::sample(const AfrNode& node, Random& random) const {
  const CellPatch& patch = patchOf(node);
  const int place = patch.begin + indexDraw(random, patch.end - patch.begin);
  const int cell = tree(node).order()[static_cast<std::size_t>(place)];
  const double share_x = unitDraw(random), share_y = unitDraw(random), share_angle = unitDraw(random);
  return at(node, cell, share_x, share_y, share_angle);
}

}  // namespace b4p
