// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planners/reach/bik_rrt.h"
#include "planners/reach/goal_configurations.h"
#include "planners/reach/reach_search.h"

namespace b4p {

/// The search of BIKRRT. Goal configurations are roots of trees of their own.
class BikSearch : public ReachSearch {
 public:
  BikSearch(const ompl::base::SpaceInformationPtr& si, const ReachGoal& goal,
            const BIKRRTParameters& parameters, std::uint64_t seed, ReachStatistics& statistics);

  std::optional<Junction> step() override;

 private:
  void seekGoal();
  std::optional<Junction> grow();

  const BIKRRTParameters parameters_;
  GoalConfigurations configurations_;
  const Node* new_goal_ = nullptr;  ///< a root to which the straight way has not been tried
  Side next_side_ = Side::kPick;
};

}  // namespace b4p
