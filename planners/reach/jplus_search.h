// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <random>

#include "planners/reach/approach_table.h"
#include "planners/reach/jplus_rrt.h"
#include "planners/reach/reach_search.h"

namespace b4p {

/// The search of JPlusRRT. Steering is not repeated from a node to the same grasp, nor from the nodes that a
/// blocked way to that grasp has left.
class JPlusSearch : public ReachSearch {
 public:
  JPlusSearch(const ompl::base::SpaceInformationPtr& si, const ReachGoal& goal,
              const JPlusRRTParameters& parameters, std::uint64_t seed, ReachStatistics& statistics);

  std::optional<Junction> step() override;

 protected:
  void startPlanted(const Node* root) override;

 private:
  std::optional<Junction> growRandomly();
  std::optional<Junction> steer(GraspId grasp);
  std::optional<Junction> reached(const Node* node, GraspId grasp);

  const JPlusRRTParameters parameters_;
  std::unique_ptr<ReachContext> context_;
  ApproachTable approaches_;
  std::mt19937_64 random_;
  ompl::base::ScopedState<> next_;
};

}  // namespace b4p
