// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

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
  /// A goal configuration.
  struct Target {
    const Node* root;
    const Node* blocked;  ///< from here the motion to it could not begin
  };

  void seekGoal();
  void aimAt(const Node* goal_root);
  std::optional<Junction> grow();
  std::optional<Junction> growTo(Target& target);
  std::optional<Junction> growTo(const ompl::base::State* target);
  void dropGrasp();
  std::uint64_t inThisRound(unsigned budget) const;

  const IKRRTParameters parameters_;
  GoalConfigurations configurations_;
  GraspDeck deck_;
  GraspId grasp_ = kNoGrasp;  ///< being tried
  std::uint64_t attempts_left_ = 0;
  std::vector<Target> targets_;        ///< found so far, that of the grasp being tried last
  std::uint64_t iterations_left_ = 0;  ///< 0 while the grasp has no target
};

}  // namespace b4p
