// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/placement_problem.h"

#include <algorithm>
#include <utility>

#include <ompl/base/ScopedState.h>

#include "planners/placement/placement_path_objective.h"
#include "robots/input_error.h"

namespace b4p {

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

/// Around the limits of all arms; each arm's own are checked with its collisions.
ob::RealVectorBounds boundsAround(const std::vector<ScenePlacementWorld::Arm>& arms) {
  ob::RealVectorBounds bounds(static_cast<unsigned>(arms.front().robot->dof()));
  for (std::size_t i = 0; i < bounds.low.size(); ++i) {
    const auto joint = static_cast<Eigen::Index>(i);
    bounds.low[i] = arms.front().robot->lower()[joint];
    bounds.high[i] = arms.front().robot->upper()[joint];
    for (const auto& arm : arms) {
      bounds.low[i] = std::min(bounds.low[i], arm.robot->lower()[joint]);
      bounds.high[i] = std::max(bounds.high[i], arm.robot->upper()[joint]);
    }
  }
  return bounds;
}

void addStarts(PlacementProblem& problem) {
  ob::ScopedState<ManipulationStateSpace> state(problem.space);
  const auto& sources = problem.scene.place->arms;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const auto& arm = problem.world->arms()[i];
    const std::string collision =
        arm.checker->makeContext()->describeCollision(sources[i].start.data(), &arm.grasp);
    if (!collision.empty())
      throw InputError(problem.scene.file, "place.arms." + sources[i].name + ".start",
                       "is not free: " + collision);
    std::copy(sources[i].start.begin(), sources[i].start.end(), state->q);
    state->grasp = static_cast<GraspId>(i);
    problem.pdef->addStartState(state);
  }
}

}  // namespace

PlacementProblem makePlacementProblem(const Scene& scene, const PlacementOptions& options,
                                      std::shared_ptr<const PlacementObjective> objective) {
  PlacementProblem problem;
  problem.scene = scene;
  problem.world = std::make_shared<ScenePlacementWorld>(scene);
  problem.objective = objective != nullptr ? std::move(objective)
                                           : problem.world->geometry().objective(scene.place->objective);
  problem.space = std::make_shared<ManipulationStateSpace>(boundsAround(problem.world->arms()));
  problem.space->setGraspCount([world = problem.world] { return world->armCount(); });
  problem.counts = std::make_shared<ValidityCounts>();
  problem.si = makeManipulationSpaceInformation(problem.space, problem.world->motions(), problem.counts);
  problem.goal = std::make_shared<PlacementGoal>(problem.si, problem.world, problem.objective, options);
  problem.setup = std::make_shared<og::SimpleSetup>(problem.si);
  problem.setup->setGoal(problem.goal);
  problem.setup->setOptimizationObjective(std::make_shared<PlacementPathObjective>(problem.si, problem.goal));
  problem.pdef = problem.setup->getProblemDefinition();
  addStarts(problem);
  return problem;
}

}  // namespace b4p
