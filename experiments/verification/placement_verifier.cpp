// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/verification/placement_verifier.h"

#include <cmath>

#include "experiments/verification/clearance.h"
#include "experiments/verification/collision_sweep.h"
#include "experiments/verification/footing.h"
#include "experiments/verification/kinematics.h"
#include "experiments/verification/number_text.h"
#include "experiments/verification/others_at_rest.h"
#include "experiments/verification/path_checks.h"
#include "experiments/verification/task_checks.h"
#include "robots/input_error.h"

namespace b4p {

using verification::text;

struct PlacementVerifier::Parts {
  Parts(const Scene& described, double objective_sign)
      : scene(described), sign(objective_sign), footing(described), clearance(described) {}

  const Scene& scene;
  double sign;
  verification::Footing footing;
  verification::Clearance clearance;
};

namespace {

/// The scene as one arm has it, the robot's other arms at rest.
Scene sceneOf(const Scene& scene, std::size_t index) {
  const PlacementArm& arm = scene.placing().arms[index];
  Scene own = scene;
  own.robot = {arm.robot_file, arm.urdf_file, verification::withOthersAtRest(scene.placing(), index)};
  own.X_WB = arm.X_WB;
  return own;
}

std::string startProblem(const PlacementArm& arm, const std::vector<double>& first) {
  constexpr double kTolerance = 1e-9;  // rad or m
  for (std::size_t i = 0; i < first.size(); ++i)
    if (!(std::abs(first[i] - arm.start[i]) <= kTolerance))
      return "way-point 0: joint " + std::to_string(i) + " is at " + text(first[i]) + ", not at its start " +
             text(arm.start[i]);
  return "";
}

std::string poseProblem(const Eigen::Isometry3d& found, const Eigen::Isometry3d& stated) {
  constexpr double kTolerance = 1e-6;  // m, and entries of rotation matrices
  const double difference = (found.matrix() - stated.matrix()).cwiseAbs().maxCoeff();
  return difference <= kTolerance ? "" : "the object ends " + text(difference) + " from the pose stated";
}

}  // namespace

PlacementVerifier::PlacementVerifier(const Scene& scene, double sign)
    : parts_(std::make_unique<Parts>(scene, sign)) {}

PlacementVerifier::~PlacementVerifier() = default;

PlacementVerification PlacementVerifier::verify(const PlacementImprovement& improvement,
                                                const std::vector<std::string>& joint_names) const {
  const auto index = static_cast<std::size_t>(improvement.arm);
  const PlacementArm& arm = parts_->scene.placing().arms.at(index);
  const Scene scene = sceneOf(parts_->scene, index);
  const verification::Kinematics robot(scene.robot.urdf_file, scene.robot.description, scene.X_WB);
  PlacementVerification outcome;
  outcome.step_m = scene.edge_step_m / verification::kFinerThanPlanning;
  const auto fails = [&outcome](const std::string& failure) {
    outcome.failure = failure;
    return !failure.empty();
  };
  PlanResult rows;
  rows.joint_names = joint_names;
  rows.path = improvement.path;
  if (fails(verification::rowsProblem(scene, rows, robot))) return outcome;
  if (fails(startProblem(arm, improvement.path.front()))) return outcome;
  verification::CollisionSweep sweep(scene, robot, arm.grasp, outcome.step_m,
                                     verification::otherRobots(scene.placing(), index));
  if (fails(verification::motionProblem(improvement.path, sweep))) return outcome;
  outcome.configurations = sweep.samples();
  outcome.clearance_m = sweep.clearance_m();
  const Eigen::Isometry3d X_WO = verification::objectPose(robot, arm.grasp, improvement.path.back());
  if (fails(poseProblem(X_WO, improvement.X_WO))) return outcome;
  if (fails(parts_->footing.problem(X_WO, outcome.gap_m))) return outcome;
  outcome.objective_m = parts_->sign * parts_->clearance.mean_m(X_WO);
  const double tolerance_m = 1.5 * scene.placing().cell_m;
  if (!(std::abs(outcome.objective_m - improvement.objective_m) <= tolerance_m)) {
    fails("the objective is " + text(outcome.objective_m) + " m, not " + text(improvement.objective_m) +
          " m");
    return outcome;
  }
  outcome.passed = true;
  return outcome;
}

}  // namespace b4p
