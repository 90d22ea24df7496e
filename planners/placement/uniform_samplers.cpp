// SPDX-License-Identifier: BSD-3-Clause
#include "planners/placement/uniform_samplers.h"

#include <algorithm>

#include "planners/placement/tree_search.h"

namespace b4p {

bool UniformChildren::draw(std::mt19937_64& random, double, Placement& placement, Branch& branch) {
  branch = 0;
  AfrNode node;
  for (int count; (count = hierarchy_.childCount(node)) > 0;)
    node = hierarchy_.child(node, indexDraw(random, count));
  placement = hierarchy_.sample(node, random);
  return true;
}

UniformArea::UniformArea(const PlacementWorld& world) : hierarchy_(world) {
  std::size_t cells = 0;
  for (const ContactRegion& region : world.regions()) cells_up_to_.push_back(cells += region.cells.size());
}

bool UniformArea::draw(std::mt19937_64& random, double, Placement& placement, Branch& branch) {
  branch = 0;
  AfrNode node;
  node.depth = AfrHierarchy::kFullyChosen;
  node.arm = indexDraw(random, hierarchy_.world().armCount());
  node.face = indexDraw(random, hierarchy_.world().faceCount());
  const auto cell = static_cast<std::size_t>(indexDraw(random, static_cast<int>(cells_up_to_.back())));
  node.region = static_cast<int>(std::upper_bound(cells_up_to_.begin(), cells_up_to_.end(), cell) -
                                 cells_up_to_.begin());
  placement = hierarchy_.sample(node, random);
  return true;
}

std::unique_ptr<PlacementSampler> makePlacementSampler(const PlacementWorld& world,
                                                       const PlacementObjective& objective,
                                                       const PlacementOptions& options) {
  switch (options.sampling) {
    case PlacementSampling::kUniformChildren:
      return std::make_unique<UniformChildren>(world);
    case PlacementSampling::kUniformArea:
      return std::make_unique<UniformArea>(world);
    case PlacementSampling::kTreeSearch:
      break;
  }
  return std::make_unique<TreeSearch>(world, objective, options);
}

}  // namespace b4p
