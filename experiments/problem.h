// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "experiments/planning_problem.h"
#include "experiments/scene_region.h"
#include "planners/place_goal.h"

namespace b4p {

/// A scene of pick and place as an OMPL problem: start states are picks (addStartStates()); B4P draws more by
/// itself. A problem belongs to one query, because its region learns grasps while planners run.
struct Problem : PlanningProblem {
  std::shared_ptr<const SceneRegion> region;
  std::shared_ptr<PlaceGoal> goal;

  void seedGoal(std::uint64_t seed) override { goal->seed(seed); }
  void plantStarts(int picks, std::uint64_t seed,
                   const ompl::base::PlannerTerminationCondition& done) const override;
  double opening_m(GraspId grasp) const override { return region->grasp(grasp).opening_m; }
  void interpret(const ompl::geometric::PathGeometric& path, PlanResult& result) const override;

  /// @throws InputError when the object at its start pose is nearer to an obstacle than contact_clearance_m,
  ///   none of many grasps drawn is valid there (with the commonest reason), or no placement drawn can be
  ///   reached with any grasp that is
  void requireSolvable() const override;

 private:
  friend Problem makeProblem(const Scene& scene, CheckerKind checker);
  friend Problem withGraspsOnly(const Problem& problem, std::vector<Grasp> grasps);
  void addRegion(std::shared_ptr<const SceneRegion> of_region);
};

/// @throws InputError when the robot's files are at fault, or the scene's task is another
Problem makeProblem(const Scene& scene, CheckerKind checker = CheckerKind::kFast);

/// The same task with no other grasps than these, numbered from 0. Shares robot and collision checker.
Problem withGraspsOnly(const Problem& problem, std::vector<Grasp> grasps);

/// Draws picks until the problem has `wanted` start states more, or, where there are fewer grasps than that,
/// one for each grasp that has one. Ends early when `done`.
/// @return how many were added
int addStartStates(const Problem& problem, int wanted, std::uint64_t seed,
                   const ompl::base::PlannerTerminationCondition& done);

}  // namespace b4p
