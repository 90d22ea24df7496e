// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <random>

#include "planners/placement/placement_objective.h"
#include "planners/placement/placement_options.h"
#include "planners/placement/placement_world.h"

namespace b4p {

/// Which tests a drawn placement passed. Tests that were not made count as failed.
struct PlacementOutcome {
  bool stable = false;
  bool hopeless = false;  ///< stable, but a bound of the objective is not above its threshold
  bool object_free = false;
  bool better = false;  ///< stable, object free, and the objective above its threshold
  bool hand_free = false;
  bool reachable = false;
  bool arm_free = false;
  double objective = -std::numeric_limits<double>::infinity();  ///< known when stable and object free

  bool valid() const { return better && arm_free; }
};

/// Where placements come from. For one thread at a time; learn() may come later than other draws.
class PlacementSampler {
 public:
  /// Where a draw came from, for learn().
  using Branch = std::int32_t;

  virtual ~PlacementSampler() = default;

  /// @param threshold  what the objective has to exceed
  /// @return false when no branch is left that could
  virtual bool draw(std::mt19937_64& random, double threshold, Placement& placement, Branch& branch) = 0;

  virtual void learn(Branch, const PlacementOutcome&) {}

  /// A valid placement that was found by other means.
  virtual void learnReached(const Placement&) {}

  virtual void thresholdRaised(double /*threshold*/) {}
};

/// @param world, objective  have to outlive the sampler; the world has arms, faces and regions
std::unique_ptr<PlacementSampler> makePlacementSampler(const PlacementWorld& world,
                                                       const PlacementObjective& objective,
                                                       const PlacementOptions& options);

}  // namespace b4p
