// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/SimpleSetup.h>

#include "experiments/checker_choice.h"
#include "experiments/scene.h"
#include "experiments/scene_motion_checker.h"
#include "experiments/scene_region.h"
#include "planners/manipulation_state_space.h"
#include "planners/manipulation_validity.h"
#include "planners/place_goal.h"
#include "state_validity/collision_checker.h"

namespace b4p {

/// A scene as an OMPL problem: any planner of `si` solves it once it has start states (addStartStates()); B4P
/// draws more by itself. A problem belongs to one query, because its region learns grasps while planners run.
struct Problem {
  Scene scene;
  std::shared_ptr<const Manipulator> robot;
  std::shared_ptr<const CollisionChecker> checker;
  std::shared_ptr<const SceneRegion> region;
  std::shared_ptr<ManipulationStateSpace> space;
  std::shared_ptr<const SceneMotionChecker> motions;
  ompl::base::SpaceInformationPtr si;
  std::shared_ptr<ValidityCounts> counts;
  std::shared_ptr<PlaceGoal> goal;
  ompl::geometric::SimpleSetupPtr setup;  ///< holds pdef
  ompl::base::ProblemDefinitionPtr pdef;
};

/// @throws InputError when the robot's files are at fault
Problem makeProblem(const Scene& scene, CheckerKind checker = CheckerKind::kFast);

/// The same task with no other grasps than these, numbered from 0. Shares robot and collision checker.
Problem withGraspsOnly(const Problem& problem, std::vector<Grasp> grasps);

/// Draws picks until the problem has `wanted` start states more, or, where there are fewer grasps than that,
/// one for each grasp that has one. Ends early when `done`.
/// @return how many were added
int addStartStates(const Problem& problem, int wanted, std::uint64_t seed,
                   const ompl::base::PlannerTerminationCondition& done);

/// A number derived from a seed and a stream number, good as the seed of another generator. Never 0; fits 32
/// bits.
std::uint64_t derivedSeed(std::uint64_t seed, std::uint64_t stream);

}  // namespace b4p
