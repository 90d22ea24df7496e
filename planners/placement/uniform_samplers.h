// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planners/placement/afr_hierarchy.h"
#include "planners/placement/placement_sampler.h"

namespace b4p {

/// A child drawn uniformly at each level of the AFR hierarchy, down to a leaf: the paper's baseline. Small
/// regions are drawn from as often as large ones.
class UniformChildren : public PlacementSampler {
 public:
  explicit UniformChildren(const PlacementWorld& world) : hierarchy_(world) {}
  bool draw(std::mt19937_64& random, double threshold, Placement& placement, Branch& branch) override;

 private:
  AfrHierarchy hierarchy_;
};

/// Arm, face and angle uniform, all cells of all regions alike.
class UniformArea : public PlacementSampler {
 public:
  explicit UniformArea(const PlacementWorld& world);
  bool draw(std::mt19937_64& random, double threshold, Placement& placement, Branch& branch) override;

 private:
  AfrHierarchy hierarchy_;
  std::vector<std::size_t> cells_up_to_;  ///< in the regions up to this one
};

}  // namespace b4p
