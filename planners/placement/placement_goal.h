// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <random>
#include <string>

#include <ompl/base/goals/GoalSampleableRegion.h>

#include "planners/context_pool.h"
#include "planners/placement/placement_objective.h"
#include "planners/placement/placement_options.h"
#include "planners/placement/placement_world.h"

namespace b4p {

class PlacementSampler;

/// "The object stands somewhere, better than so far": a goal over a ManipulationStateSpace whose modes are
/// arms (state = q, arm), for any OMPL planner. A state is in the goal when the object it holds is stable,
/// collides with nothing, and has an objective above objectiveThreshold(). Whether the arm is free is for the
/// problem's validity checker; samples have passed that test as well.
///
/// What draws have taught is kept until seed() or clearSearch(). Any thread may call anything; on one thread
/// a seed determines the samples. Nothing throws once constructed, but for std::bad_alloc: an exception out
/// of the world or the objective ends sampling, and problem() says what it was.
class PlacementGoal : public ompl::base::GoalSampleableRegion {
 public:
  /// @throws std::invalid_argument for a missing world or objective, options out of range, and a state space
  ///   that is no ManipulationStateSpace of the world's dof()
  PlacementGoal(const ompl::base::SpaceInformationPtr& si, std::shared_ptr<const PlacementWorld> world,
                std::shared_ptr<const PlacementObjective> objective, const PlacementOptions& options = {});
  ~PlacementGoal() override;

  const PlacementWorld& world() const { return *world_; }
  const PlacementObjective& objective() const { return *objective_; }
  const PlacementOptions& options() const { return options_; }

  /// Restarts the stream of draws, forgets what they have taught and clears the statistics.
  void seed(std::uint64_t seed);

  /// Samples have to have an objective above this; -infinity at first.
  void setObjectiveThreshold(double threshold);
  double objectiveThreshold() const { return threshold_.load(std::memory_order_acquire); }

  /// Objective of the object's pose at a state; -infinity for a state outside the bounds or with no arm.
  double objective(const ompl::base::State* state) const;

  /// Draws until a valid placement is found, at most `attempts` times. False: none found; `state` is then
  /// outside the bounds.
  bool sample(ompl::base::State* state, unsigned attempts) const;

  /// Tells the search of a placement that was reached by other means, such as local optimisation: it counts
  /// as one visit with reward 1 at its place in the hierarchy.
  /// @param value  its objective
  void reportReached(const ompl::base::State* state, double value) const;

  PlacementStatistics statistics() const;

  /// Why nothing can be drawn any more (no region, no face, a failed objective or world); empty while
  /// something can.
  std::string problem() const;

  /// sample() with options().attempts; a state outside the bounds, which planners reject, when none is found.
  void sampleGoal(ompl::base::State* state) const override;
  unsigned int maxSampleCount() const override;
  bool couldSample() const override;

  /// How many of "stable", "object free" and "better than the threshold" a state lacks; 0 exactly inside the
  /// goal, infinite outside the bounds or with no arm.
  double distanceGoal(const ompl::base::State* state) const override;
  bool isStartGoalPairValid(const ompl::base::State* start, const ompl::base::State* goal) const override;

 private:
  struct Search;

  std::shared_ptr<const PlacementWorld> world_;
  std::shared_ptr<const PlacementObjective> objective_;
  PlacementOptions options_;
  std::atomic<double> threshold_;
  mutable ContextPool<PlacementContext> contexts_;
  std::unique_ptr<Search> search_;
};

}  // namespace b4p
