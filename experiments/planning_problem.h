// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>

#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/geometric/SimpleSetup.h>

#include "experiments/checker_choice.h"
#include "experiments/result.h"
#include "experiments/scene.h"
#include "experiments/scene_motion_checker.h"
#include "planners/manipulation_state_space.h"
#include "planners/manipulation_validity.h"
#include "state_validity/collision_checker.h"

namespace b4p {

/// A scene as an OMPL problem: any planner of `si` that is made for the scene's kind of task solves it once
/// it has start states. What depends on the task is virtual. A problem belongs to one query.
struct PlanningProblem {
  virtual ~PlanningProblem() = default;

  Scene scene;
  std::shared_ptr<const Manipulator> robot;
  std::shared_ptr<const CollisionChecker> checker;
  std::shared_ptr<ManipulationStateSpace> space;
  std::shared_ptr<const SceneMotionChecker> motions;
  ompl::base::SpaceInformationPtr si;
  std::shared_ptr<ValidityCounts> counts;
  ompl::geometric::SimpleSetupPtr setup;  ///< holds pdef
  ompl::base::ProblemDefinitionPtr pdef;

  /// Restarts the stream of random numbers that the goal draws from.
  virtual void seedGoal(std::uint64_t seed) = 0;

  /// Gives the problem its start states. Ends early when `done`.
  /// @param picks  how many are wanted where there is a choice
  virtual void plantStarts(int picks, std::uint64_t seed,
                           const ompl::base::PlannerTerminationCondition& done) const = 0;

  /// Opening of the gripper (m) in states of that grasp.
  virtual double opening_m(GraspId grasp) const = 0;

  /// Adds to a result what its path, which solves this problem, means: grasp and poses.
  virtual void interpret(const ompl::geometric::PathGeometric& path, PlanResult& result) const = 0;

  /// @throws InputError when no planner can solve the problem, as far as that is found out within a second
  virtual void requireSolvable() const = 0;

 protected:
  PlanningProblem() = default;
  PlanningProblem(const PlanningProblem&) = default;
  PlanningProblem& operator=(const PlanningProblem&) = default;

  /// Scene, robot and collision checker.
  /// @param object  what the hand may carry, in its own frame
  /// @throws InputError when the robot's files are at fault
  void addWorld(const Scene& of_scene, const std::vector<PlacedShape>& object, CheckerKind checker_kind);

  /// All that planners need but the goal.
  /// @param region  knows the grasps of states; nullptr where nothing is ever held
  void addPlanningParts(const std::shared_ptr<const SceneRegion>& region);
};

/// The problem that a scene's task makes.
/// @throws InputError when the robot's files are at fault
std::unique_ptr<PlanningProblem> makePlanningProblem(const Scene& scene,
                                                     CheckerKind checker = CheckerKind::kFast);

/// A number derived from a seed and a stream number, good as the seed of another generator. Never 0; fits 32
/// bits.
std::uint64_t derivedSeed(std::uint64_t seed, std::uint64_t stream);

}  // namespace b4p
