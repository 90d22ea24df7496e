// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/planning_problem.h"

#include <limits>
#include <stdexcept>
#include <utility>

#include "experiments/problem.h"
#include "experiments/reach/reach_problem.h"
#include "robots/input_error.h"
#include "robots/robot_model.h"

namespace b4p {

namespace ob = ompl::base;

namespace {

ob::RealVectorBounds jointBounds(const Manipulator& robot) {
  ob::RealVectorBounds bounds(static_cast<unsigned>(robot.dof()));
  for (int i = 0; i < robot.dof(); ++i) {
    bounds.setLow(static_cast<unsigned>(i), robot.lower()[i]);
    bounds.setHigh(static_cast<unsigned>(i), robot.upper()[i]);
  }
  return bounds;
}

/// Makes the problem of each kind of task.
struct ProblemMaker {
  const Scene& scene;
  CheckerKind checker;

  std::unique_ptr<PlanningProblem> operator()(const PickPlaceTask&) const {
    return std::make_unique<Problem>(makeProblem(scene, checker));
  }
  std::unique_ptr<PlanningProblem> operator()(const ReachTask& task) const {
    return std::make_unique<ReachProblem>(scene, task, checker);
  }
  std::unique_ptr<PlanningProblem> operator()(const PlacementTask&) const {
    throw InputError(scene.file, "place", "is a task of placement, which `b4p place` plans");
  }
};

}  // namespace

void PlanningProblem::addWorld(const Scene& of_scene, const std::vector<PlacedShape>& object,
                               CheckerKind checker_kind) {
  scene = of_scene;
  robot = std::make_shared<Manipulator>(loadUrdf(scene.robot.urdf_file), scene.robot.description, scene.X_WB,
                                        scene.robot.file);
  CollisionProblem collision;
  collision.robot = robot;
  collision.obstacles = scene.obstacles;
  collision.object = object;
  collision.edge_step_m = scene.edge_step_m;
  try {
    checker = makeChecker(checker_kind, std::move(collision));
  } catch (const std::invalid_argument& e) {
    throw InputError(scene.file, "", e.what());
  }
}

void PlanningProblem::addPlanningParts(const std::shared_ptr<const SceneRegion>& region) {
  space = std::make_shared<ManipulationStateSpace>(jointBounds(*robot));
  counts = std::make_shared<ValidityCounts>();
  motions = std::make_shared<SceneMotionChecker>(checker, region);
  si = makeManipulationSpaceInformation(space, motions, counts);
  setup = std::make_shared<ompl::geometric::SimpleSetup>(si);
  pdef = setup->getProblemDefinition();
}

std::unique_ptr<PlanningProblem> makePlanningProblem(const Scene& scene, CheckerKind checker) {
  return std::visit(ProblemMaker{scene, checker}, scene.task);
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
