// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/problem.h"

#include <utility>

#include <ompl/base/ScopedState.h>

#include "experiments/preflight.h"

namespace b4p {

namespace ob = ompl::base;

void Problem::addRegion(std::shared_ptr<const SceneRegion> of_region) {
  region = std::move(of_region);
  addPlanningParts(region);
  space->setGraspCount([known = region] { return known->graspCount(); });
  goal = std::make_shared<PlaceGoal>(si, region);
  setup->setGoal(goal);
}

void Problem::plantStarts(int picks, std::uint64_t seed, const ob::PlannerTerminationCondition& done) const {
  addStartStates(*this, picks, seed, done);
}

void Problem::interpret(const ompl::geometric::PathGeometric& path, PlanResult& result) const {
  result.grasp_id = path.getState(0)->as<ManipulationStateSpace::StateType>()->grasp;
  result.grasp = region->grasp(result.grasp_id);
  result.X_WO_pick = region->objectPose(result.path.front().data(), result.grasp);
  result.X_WO_place = region->objectPose(result.path.back().data(), result.grasp);
}

void Problem::requireSolvable() const { requirePickAndPlaceSolvable(*this); }

Problem makeProblem(const Scene& scene, CheckerKind checker) {
  Problem problem;
  problem.addWorld(scene, scene.pickPlace().object, checker);
  problem.addRegion(std::make_shared<SceneRegion>(scene, problem.checker));
  return problem;
}

Problem withGraspsOnly(const Problem& problem, std::vector<Grasp> grasps) {
  Problem restricted;
  restricted.scene = problem.scene;
  restricted.robot = problem.robot;
  restricted.checker = problem.checker;
  restricted.addRegion(std::make_shared<SceneRegion>(
      problem.scene, problem.checker, std::make_unique<ListedGraspSampler>(std::move(grasps))));
  return restricted;
}

int addStartStates(const Problem& problem, int wanted, std::uint64_t seed,
                   const ob::PlannerTerminationCondition& done) {
  constexpr int kDrawsPerGrasp = 8;
  const auto context = problem.region->makeSceneContext(seed);
  ob::ScopedState<ManipulationStateSpace> state(problem.space);
  int added = 0;
  const auto add = [&] {
    problem.pdef->addStartState(state);
    ++added;
  };
  if (problem.region->finite() && problem.region->graspCount() <= wanted) {
    for (state->grasp = 0; state->grasp < problem.region->graspCount(); ++state->grasp)
      for (int draw = 0; draw < kDrawsPerGrasp && !done(); ++draw)
        if (context->pickRoot(state->grasp, state->q)) {
          add();
          break;
        }
    return added;
  }
  while (added < wanted && !done())
    if (context->samplePick(state->q, state->grasp)) add();
  return added;
}

}  // namespace b4p
