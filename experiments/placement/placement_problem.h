// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include <ompl/geometric/SimpleSetup.h>

#include "experiments/placement/scene_placement_world.h"
#include "experiments/scene.h"
#include "planners/manipulation_state_space.h"
#include "planners/manipulation_validity.h"
#include "planners/placement/placement_goal.h"

namespace b4p {

/// A placement scene as an OMPL problem: each arm at its start with the object in its hand is a start state,
/// and any planner of `si` finds a way to a placement. A problem belongs to one query, because its goal
/// learns.
struct PlacementProblem {
  Scene scene;
  std::shared_ptr<const ScenePlacementWorld> world;
  std::shared_ptr<const PlacementObjective> objective;
  std::shared_ptr<ManipulationStateSpace> space;
  std::shared_ptr<ValidityCounts> counts;
  ompl::base::SpaceInformationPtr si;
  std::shared_ptr<PlacementGoal> goal;
  ompl::geometric::SimpleSetupPtr setup;  ///< holds pdef
  ompl::base::ProblemDefinitionPtr pdef;
};

/// @param scene      with a placement task
/// @param objective  nullptr: the scene's own
/// @throws InputError when the robot's files are at fault, pre-processing finds nothing to place on or with,
/// or
///   an arm collides at its start
PlacementProblem makePlacementProblem(const Scene& scene, const PlacementOptions& options = {},
                                      std::shared_ptr<const PlacementObjective> objective = nullptr);

}  // namespace b4p
