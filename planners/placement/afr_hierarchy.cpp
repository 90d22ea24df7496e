// SPDX-License-Identifier: BSD-3-Clause
#include "planners/placement/afr_hierarchy.h"

#include <algorithm>
#include <cmath>

namespace b4p {
namespace {

constexpr double kFullTurn_rad = 2.0 * 3.14159265358979323846;
constexpr int kAngleParts = 4;

}  // namespace

CellTree::CellTree(const ContactRegion& region) : region_(&region), order_(region.cells.size()) {
  for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = static_cast<int>(i);
  addPatch(0, static_cast<int>(order_.size()));
  for (std::size_t i = 0; i < patches_.size(); ++i) split(static_cast<int>(i));
}

int CellTree::addPatch(int begin, int end) {
  CellPatch patch;
  patch.begin = begin;
  patch.end = end;
  Eigen::AlignedBox2d box;
  for (int i = begin; i < end; ++i)
    box.extend(region_->cells[static_cast<std::size_t>(order_[static_cast<std::size_t>(i)])]);
  if (begin < end) {
    patch.centre_m = box.center();
    patch.radius_m = ((box.max() - box.min()).array() + region_->cell_m).matrix().norm() / 2.0;
  }
  patches_.push_back(patch);
  return static_cast<int>(patches_.size()) - 1;
}

void CellTree::split(int number) {
  const CellPatch whole = patch(number);
  if (whole.end - whole.begin < 2) return;
  const auto begin = order_.begin() + whole.begin, end = order_.begin() + whole.end;
  const auto below = [&](int axis) {
    return [this, axis, middle = whole.centre_m[axis]](int cell) {
      return region_->cells[static_cast<std::size_t>(cell)][axis] <= middle;
    };
  };
  const auto half = std::stable_partition(begin, end, below(0));
  const auto low = std::stable_partition(begin, half, below(1));
  const auto high = std::stable_partition(half, end, below(1));
  std::vector<int> children;
  for (const auto& [from, to] : {std::pair(begin, low), {low, half}, {half, high}, {high, end}})
    if (from != to)
      children.push_back(
          addPatch(static_cast<int>(from - order_.begin()), static_cast<int>(to - order_.begin())));
  patches_[static_cast<std::size_t>(number)].children = std::move(children);
}

int CellTree::cellAt(const Eigen::Vector2d& p_W) const {
  for (std::size_t i = 0; i < region_->cells.size(); ++i)
    if ((p_W - region_->cells[i]).cwiseAbs().maxCoeff() <= region_->cell_m / 2.0 * (1.0 + 1e-9))
      return static_cast<int>(i);
  return -1;
}

AfrHierarchy::AfrHierarchy(const PlacementWorld& world) : world_(world) {
  for (const ContactRegion& region : world.regions()) trees_.emplace_back(region);
}

double AfrHierarchy::angleWidth(const AfrNode& node) {
  return kFullTurn_rad / std::pow(kAngleParts, node.angle_depth);
}

int AfrHierarchy::childCount(const AfrNode& node) const {
  if (node.depth == 0) return world_.armCount();
  if (node.depth == 1) return world_.faceCount();
  if (node.depth == 2) return static_cast<int>(trees_.size());
  const int parts = static_cast<int>(patchOf(node).children.size());
  const bool turns = node.angle_depth < kAngleDepth;
  if (parts == 0) return turns ? kAngleParts : 0;
  return turns ? parts * kAngleParts : parts;
}

AfrNode AfrHierarchy::child(const AfrNode& node, int number) const {
  AfrNode child = node;
  ++child.depth;
  if (node.depth == 0) {
    child.arm = number;
  } else if (node.depth == 1) {
    child.face = number;
  } else if (node.depth == 2) {
    child.region = number;
  } else {
    const bool turns = node.angle_depth < kAngleDepth;
    const int part = turns ? number / kAngleParts : number;
    if (!patchOf(node).children.empty()) child.patch = patchOf(node).children[static_cast<std::size_t>(part)];
    if (turns) {
      ++child.angle_depth;
      child.angle_low_rad += (number % kAngleParts) * angleWidth(child);
    }
  }
  return child;
}

int AfrHierarchy::childOf(const AfrNode& node, const Placement& placement) const {
  if (node.depth == 0) return placement.arm;
  if (node.depth == 1) return placement.face;
  if (node.depth == 2) return placement.region;
  const int cell = tree(node).cellAt(placement.p_WV);
  for (int number = 0; number < childCount(node); ++number) {
    const AfrNode candidate = child(node, number);
    const double turned = placement.angle_rad - candidate.angle_low_rad;
    if (turned < 0.0 || turned >= angleWidth(candidate)) continue;
    const CellPatch& patch = patchOf(candidate);
    const auto& order = tree(node).order();
    if (std::find(order.begin() + patch.begin, order.begin() + patch.end, cell) != order.begin() + patch.end)
      return number;
  }
  return -1;
}

Placement AfrHierarchy::at(const AfrNode& node, int cell, double share_x, double share_y,
                           double share_angle) const {
  const ContactRegion& region = tree(node).region();
  Placement placement;
  placement.arm = node.arm;
  placement.face = node.face;
  placement.region = node.region;
  placement.p_WV = region.cells[static_cast<std::size_t>(cell)] +
                   region.cell_m * Eigen::Vector2d(share_x - 0.5, share_y - 0.5);
  placement.angle_rad = node.angle_low_rad + share_angle * angleWidth(node);
  return placement;
}

Placement AfrHierarchy::middle(const AfrNode& node) const {
  Placement placement;
  placement.arm = node.arm;
  placement.face = node.face;
  placement.region = node.region;
  placement.p_WV = patchOf(node).centre_m;
  placement.angle_rad = node.angle_low_rad + angleWidth(node) / 2.0;
  return placement;
}

}  // namespace b4p
