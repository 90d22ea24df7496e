// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/verification/verifier.h"

#include <cmath>

#include "experiments/verification/collision_sweep.h"
#include "experiments/verification/kinematics.h"
#include "experiments/verification/number_text.h"
#include "experiments/verification/path_checks.h"
#include "experiments/verification/reach_checks.h"
#include "experiments/verification/task_checks.h"
#include "robots/input_error.h"

namespace b4p {
namespace {

using verification::CollisionSweep;
using verification::Kinematics;

/// What a result's path means for each kind of task.
class TaskCheck {
 public:
  TaskCheck(const Scene& scene, const PlanResult& result, const Kinematics& robot)
      : scene_(scene), result_(result), robot_(robot) {}

  /// The first thing wrong with grasp and ends of the path.
  std::string operator()(const PickPlaceTask&) const {
    const std::string problem = verification::graspProblem(scene_, result_, robot_);
    if (!problem.empty()) return problem;
    return verification::endsProblem(scene_, result_,
                                     verification::objectPose(robot_, result_.grasp, result_.path.front()),
                                     verification::objectPose(robot_, result_.grasp, result_.path.back()));
  }
  std::string operator()(const ReachTask& task) const {
    return verification::reachProblem(task, result_, robot_, scene_.robot.description.max_opening_m);
  }
  std::string operator()(const PlacementTask&) const {
    return "scene " + scene_.name + ": is a placement task, whose results are others";
  }

 private:
  const Scene& scene_;
  const PlanResult& result_;
  const Kinematics& robot_;
};

/// How the hand goes along a path: holding the object, or empty and fully open.
struct HandOf {
  const Scene& scene;
  const PlanResult& result;

  Grasp operator()(const PickPlaceTask&) const { return result.grasp; }
  Grasp operator()(const ReachTask&) const {
    return {Eigen::Isometry3d::Identity(), scene.robot.description.max_opening_m};
  }
  Grasp operator()(const PlacementTask&) const { return result.grasp; }
};

/// The first thing wrong with the result apart from collisions.
std::string taskProblem(const Scene& scene, const PlanResult& result, const Kinematics& robot) {
  std::string problem = verification::statusProblem(scene, result);
  if (problem.empty()) problem = verification::rowsProblem(scene, result, robot);
  if (problem.empty()) problem = std::visit(TaskCheck(scene, result, robot), scene.task);
  return problem;
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
  CollisionSweep sweep(scene, robot, std::visit(HandOf{scene, result}, scene.task), outcome.step_m);
  outcome.failure = verification::motionProblem(result.path, sweep);
  outcome.configurations = sweep.samples();
  outcome.passed = outcome.failure.empty();
  if (outcome.passed) outcome.clearance_m = sweep.clearance_m();
  return outcome;
}

}  // namespace b4p
