// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/reach/reach_problem.h"

#include <algorithm>
#include <limits>

#include <ompl/base/ScopedState.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "experiments/floating_body.h"
#include "experiments/reach/reach_preflight.h"
#include "experiments/reach/reach_robot.h"

namespace b4p {

namespace ob = ompl::base;

namespace {

ReachTargets targetsOf(const ReachTask& task) {
  if (!task.orientation_free)
    return ReachTargets::poses(task.X_WT, {task.position_tolerance_m, task.angle_tolerance_rad, task.flip});
  std::vector<Eigen::Vector3d> positions;
  for (const Eigen::Isometry3d& X_WT : task.X_WT) positions.push_back(X_WT.translation());
  return ReachTargets::positions(positions, task.position_tolerance_m);
}

ob::OptimizationObjectivePtr anyPath(const ob::SpaceInformationPtr& si) {
  auto objective = std::make_shared<ob::PathLengthOptimizationObjective>(si);
  objective->setCostThreshold(ob::Cost(std::numeric_limits<double>::max()));
  return objective;
}

}  // namespace

ReachProblem::ReachProblem(const Scene& of_scene, const ReachTask& of_task, CheckerKind checker_kind) {
  addWorld(of_scene, {}, checker_kind);
  addPlanningParts(nullptr);
  // Steps that planners derive from the space's extent are those of joint space alone.
  space->setGraspDistance(0.0);
  const auto hand = FloatingBody::makeChecker(checker->problem(), FloatingBody::Parts::kGripper, *checker);
  goal = std::make_shared<ReachGoal>(si, std::make_shared<ManipulatorReachRobot>(robot, hand),
                                     targetsOf(of_task));
  setup->setGoal(goal);
  setup->setOptimizationObjective(anyPath(si));
}

void ReachProblem::plantStarts(int, std::uint64_t, const ob::PlannerTerminationCondition&) const {
  ob::ScopedState<ManipulationStateSpace> start(space);
  std::copy(task().start.begin(), task().start.end(), start->q);
  start->grasp = kNoGrasp;
  pdef->addStartState(start);
}

double ReachProblem::opening_m(GraspId) const { return robot->description().max_opening_m; }

void ReachProblem::interpret(const ompl::geometric::PathGeometric& path, PlanResult& result) const {
  result.grasp_id = goal->graspOf(path.getState(static_cast<unsigned>(path.getStateCount() - 1)));
  result.X_WT_reached = robot->tcpPose(result.path.back().data());
}

void ReachProblem::requireSolvable() const {
  requireStartInsideLimits(scene, task(), *robot);
  requireFreeStart(scene, task(), *checker);
  requireGraspsWithinReach(scene, task(), *robot);
}

}  // namespace b4p
