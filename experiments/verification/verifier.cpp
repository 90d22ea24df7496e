// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/verification/verifier.h"

#include <algorithm>
#include <cmath>

#include "experiments/verification/collision_sweep.h"
#include "experiments/verification/kinematics.h"
#include "experiments/verification/number_text.h"
#include "experiments/verification/reach_checks.h"
#include "experiments/verification/task_checks.h"
#include "robots/input_error.h"

namespace b4p {
namespace {

using verification::CollisionSweep;
using verification::Kinematics;

constexpr double kFinerThanPlanning = 10.0;

Eigen::VectorXd configuration(const std::vector<double>& row) {
  return Eigen::Map<const Eigen::VectorXd>(row.data(), static_cast<Eigen::Index>(row.size()));
}

Eigen::Isometry3d objectPose(const Kinematics& robot, const Grasp& grasp, const std::vector<double>& row) {
  const auto X_WL = robot.linkPoses(configuration(row), grasp.opening_m);
  return X_WL[robot.tcpLink()] * grasp.X_OT.inverse(Eigen::Isometry);
}

/// What a result's path means for each kind of task.
class TaskCheck {
 public:
  TaskCheck(const Scene& scene, const PlanResult& result, const Kinematics& robot)
      : scene_(scene), result_(result), robot_(robot) {}

  /// The first thing wrong with grasp and ends of the path.
  std::string operator()(const PickPlaceTask&) const {
    const std::string problem = verification::graspProblem(scene_, result_, robot_);
    if (!problem.empty()) return problem;
    return verification::endsProblem(scene_, result_, objectPose(robot_, result_.grasp, result_.path.front()),
                                     objectPose(robot_, result_.grasp, result_.path.back()));
  }
  std::string operator()(const ReachTask& task) const {
    return verification::reachProblem(task, result_, robot_, scene_.robot.description.max_opening_m);
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
};

/// The first thing wrong with the result apart from collisions.
std::string taskProblem(const Scene& scene, const PlanResult& result, const Kinematics& robot) {
  std::string problem = verification::statusProblem(scene, result);
  if (problem.empty()) problem = verification::rowsProblem(scene, result, robot);
  if (problem.empty()) problem = std::visit(TaskCheck(scene, result, robot), scene.task);
  return problem;
}

/// An edge that needs too many samples: no answer in reasonable time.
std::string effortProblem(std::size_t edge, double steps, double step_m) {
  if (steps <= CollisionSweep::kMostSteps) return "";
  return "edge " + std::to_string(edge) + ": " + verification::text(steps) + " steps of " +
         verification::text(step_m) + " m are more than the " +
         verification::text(CollisionSweep::kMostSteps) + " that are checked";
}

/// The first collision. A path of one way-point is an edge from it to itself.
std::string motionProblem(const PlanResult& result, double step_m, CollisionSweep& sweep) {
  const std::size_t last = result.path.size() - 1;
  for (std::size_t i = 0; i < std::max<std::size_t>(last, 1); ++i) {
    const std::size_t next = std::min(i + 1, last);
    const Eigen::VectorXd q1 = configuration(result.path[i]), q2 = configuration(result.path[next]);
    if (const std::string problem = effortProblem(i, sweep.steps(q1, q2), step_m); !problem.empty())
      return problem;
    const auto contact = sweep.firstContact(q1, q2);
    if (!contact) continue;
    const std::string bodies = contact->first + " touches " + contact->second;
    if (contact->fraction == 0.0) return "way-point " + std::to_string(i) + ": " + bodies;
    if (contact->fraction == 1.0) return "way-point " + std::to_string(next) + ": " + bodies;
    return "edge " + std::to_string(i) + " at " + verification::text(contact->fraction) +
           " of its length: " + bodies;
  }
  return "";
}

}  // namespace

Verification verify(const Scene& scene, const PlanResult& result) {
  if (!(scene.edge_step_m > 0.0) || !std::isfinite(scene.edge_step_m))
    throw InputError(scene.file, "edge_step_m",
                     verification::text(scene.edge_step_m) + " is not a positive length");
  const Kinematics robot(scene.robot.urdf_file, scene.robot.description, scene.X_WB);
  Verification outcome;
  outcome.step_m = scene.edge_step_m / kFinerThanPlanning;
  outcome.failure = taskProblem(scene, result, robot);
  if (!outcome.failure.empty()) return outcome;
  CollisionSweep sweep(scene, robot, std::visit(HandOf{scene, result}, scene.task), outcome.step_m);
  outcome.failure = motionProblem(result, outcome.step_m, sweep);
  outcome.configurations = sweep.samples();
  outcome.passed = outcome.failure.empty();
  if (outcome.passed) outcome.clearance_m = sweep.clearance_m();
  return outcome;
}

}  // namespace b4p
