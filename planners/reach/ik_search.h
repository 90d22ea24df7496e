// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planners/reach/goal_configurations.h"
#include "planners/reach/ik_rrt.h"
#include "planners/reach/reach_search.h"

namespace b4p {

/// The search of IKRRT. A step is one attempt of inverse kinematics or one iteration of the RRT. What has
/// grown from the starts serves all grasps.
class IkSearch : public ReachSearch {
 public:
  IkSearch(const ompl::base::SpaceInformationPtr& si, const ReachGoal& goal,
           const IKRRTParameters& parameters, std::uint64_t seed, ReachStatistics& statistics);

  std::optional<Junction> step() override;

 private:
  void seekGoal();
  std::optional<Junction> growToGoal();
  std::optional<Junction> grow();
  std::optional<Junction> accepted(const Node* node);
  void dropGrasp();
  std::uint64_t inThisRound(unsigned budget) const;

  const IKRRTParameters parameters_;
  GoalConfigurations configurations_;
  GraspDeck deck_;
  GraspId grasp_ = kNoGrasp;  ///< being tried
  std::uint64_t attempts_left_ = 0;
  const Node* target_ = nullptr;  ///< the grasp's goal configuration, once there is one
  std::uint64_t iterations_left_ = 0;
  const Node* blocked_ = nullptr;  ///< from here the motion to the target could not begin
};

}  // namespace b4p
