// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "experiments/planning_problem.h"
#include "planners/reach/reach_goal.h"

namespace b4p {

/// A reaching task as an OMPL problem: one start state, a ReachGoal, nothing held in any state. Any path is
/// as good as any other: planners that go on to shorten theirs (RRTstar) end with the first.
struct ReachProblem : PlanningProblem {
  std::shared_ptr<ReachGoal> goal;

  /// @param task  of the scene
  /// @throws InputError when the robot's files are at fault
  ReachProblem(const Scene& scene, const ReachTask& task, CheckerKind checker);

  void seedGoal(std::uint64_t seed) override { goal->seed(seed); }
  void plantStarts(int picks, std::uint64_t seed,
                   const ompl::base::PlannerTerminationCondition& done) const override;
  double opening_m(GraspId grasp) const override;
  void interpret(const ompl::geometric::PathGeometric& path, PlanResult& result) const override;

  /// @throws InputError when the start is outside the joint limits or collides (naming joint or pair), or all
  ///   grasps are farther away than the arm is long
  void requireSolvable() const override;

 private:
  const ReachTask& task() const { return std::get<ReachTask>(scene.task); }
};

}  // namespace b4p
