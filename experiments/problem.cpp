// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/problem.h"

#include <limits>
#include <stdexcept>
#include <utility>

#include <ompl/base/ScopedState.h>

#include "robots/input_error.h"
#include "robots/robot_model.h"

namespace b4p {

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

std::shared_ptr<const CollisionChecker> makeChecker(const Scene& scene,
                                                    std::shared_ptr<const Manipulator> robot) {
  CollisionProblem problem;
  problem.robot = std::move(robot);
  problem.obstacles = scene.obstacles;
  problem.object = scene.object;
  problem.edge_step_m = scene.edge_step_m;
  try {
    return makeFclChecker(std::move(problem));
  } catch (const std::invalid_argument& e) {
    throw InputError(scene.file, "", e.what());
  }
}

ob::RealVectorBounds jointBounds(const Manipulator& robot) {
  ob::RealVectorBounds bounds(static_cast<unsigned>(robot.dof()));
  for (int i = 0; i < robot.dof(); ++i) {
    bounds.setLow(static_cast<unsigned>(i), robot.lower()[i]);
    bounds.setHigh(static_cast<unsigned>(i), robot.upper()[i]);
  }
  return bounds;
}

/// All that planners need, once robot, checker and region are there.
void addPlanningParts(Problem& problem) {
  problem.space = std::make_shared<ManipulationStateSpace>(jointBounds(*problem.robot));
  problem.space->setGraspCount([region = problem.region] { return region->graspCount(); });
  problem.counts = std::make_shared<ValidityCounts>();
  problem.motions = std::make_shared<SceneMotionChecker>(problem.checker, problem.region);
  problem.si = makeManipulationSpaceInformation(problem.space, problem.motions, problem.counts);
  problem.goal = std::make_shared<PlaceGoal>(problem.si, problem.region);
  problem.setup = std::make_shared<og::SimpleSetup>(problem.si);
  problem.setup->setGoal(problem.goal);
  problem.pdef = problem.setup->getProblemDefinition();
}

}  // namespace

Problem makeProblem(const Scene& scene) {
  if (scene.place) throw InputError(scene.file, "place", "a placement task is no pick-and-place task");
  Problem problem;
  problem.scene = scene;
  problem.robot = std::make_shared<Manipulator>(loadUrdf(scene.robot.urdf_file), scene.robot.description,
                                                scene.X_WB, scene.robot.file);
  problem.checker = makeChecker(scene, problem.robot);
  problem.region = std::make_shared<SceneRegion>(scene, problem.checker);
  addPlanningParts(problem);
  return problem;
}

Problem withGraspsOnly(const Problem& problem, std::vector<Grasp> grasps) {
  Problem restricted;
  restricted.scene = problem.scene;
  restricted.robot = problem.robot;
  restricted.checker = problem.checker;
  restricted.region = std::make_shared<SceneRegion>(problem.scene, problem.checker,
                                                    std::make_unique<ListedGraspSampler>(std::move(grasps)));
  addPlanningParts(restricted);
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

std::uint64_t derivedSeed(std::uint64_t seed, std::uint64_t stream) {
  // SplitMix64 (Steele, Lea, Flood 2014), folded to 32 bits.
  std::uint64_t z = seed + (stream + 1) * 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  z ^= z >> 31;
  return z % std::numeric_limits<std::uint32_t>::max() + 1;
}

}  // namespace b4p
