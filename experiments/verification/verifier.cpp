// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/verification/verifier.h"

#include <cmath>

#include "experiments/verification/collision_sweep.h"
#include "experiments/verification/kinematics.h"
#include "experiments/verification/number_text.h"
#include "experiments/verification/path_checks.h"
#include "experiments/verification/task_checks.h"
#include "robots/input_error.h"

namespace b4p {
namespace {

using verification::CollisionSweep;
using verification::Kinematics;

/// The first thing wrong with the result apart from collisions.
std::string taskProblem(const Scene& scene, const PlanResult& result, const Kinematics& robot) {
  std::string problem = verification::statusProblem(scene, result);
  if (problem.empty()) problem = verification::rowsProblem(scene, result, robot);
  if (problem.empty()) problem = verification::graspProblem(scene, result, robot);
  if (!problem.empty()) return problem;
  return verification::endsProblem(scene, result,
                                   verification::objectPose(robot, result.grasp, result.path.front()),
                                   verification::objectPose(robot, result.grasp, result.path.back()));
}

}  // namespace

Verification verify(const Scene& scene, const PlanResult& result) {
  if (!(scene.edge_step_m > 0.0) || !std::isfinite(scene.edge_step_m))
    throw InputError(scene.file, "edge_step_m",
                     verification::text(scene.edge_step_m) + " is not a positive length");
  const Kinematics robot(scene.robot.urdf_file, scene.robot.description, scene.X_WB);
  Verification outcome;
  outcome.step_m = scene.edge_step_m / verification::kFinerThanPlanning;
  outcome.failure = taskProblem(scene, result, robot);
  if (!outcome.failure.empty()) return outcome;
  CollisionSweep sweep(scene, robot, result.grasp, outcome.step_m);
  outcome.failure = verification::motionProblem(result.path, sweep);
  outcome.configurations = sweep.samples();
  outcome.passed = outcome.failure.empty();
  if (outcome.passed) outcome.clearance_m = sweep.clearance_m();
  return outcome;
}

}  // namespace b4p
