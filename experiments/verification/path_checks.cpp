// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/verification/path_checks.h"

#include <algorithm>
#include <cstddef>

#include "experiments/verification/number_text.h"

namespace b4p::verification {
namespace {

Eigen::VectorXd configuration(const std::vector<double>& row) {
  return Eigen::Map<const Eigen::VectorXd>(row.data(), static_cast<Eigen::Index>(row.size()));
}

/// An edge that needs too many samples: no answer in reasonable time.
std::string effortProblem(std::size_t edge, double steps, double step_m) {
  if (steps <= CollisionSweep::kMostSteps) return "";
  return "edge " + std::to_string(edge) + ": " + text(steps) + " steps of " + text(step_m) +
         " m are more than the " + text(CollisionSweep::kMostSteps) + " that are checked";
}

}  // namespace

Eigen::Isometry3d objectPose(const Kinematics& robot, const Grasp& grasp, const std::vector<double>& row) {
  const auto X_WL = robot.linkPoses(configuration(row), grasp.opening_m);
  return X_WL[robot.tcpLink()] * grasp.X_OT.inverse(Eigen::Isometry);
}

std::string motionProblem(const std::vector<std::vector<double>>& path, CollisionSweep& sweep) {
  const std::size_t last = path.size() - 1;
  for (std::size_t i = 0; i < std::max<std::size_t>(last, 1); ++i) {
    const std::size_t next = std::min(i + 1, last);
    const Eigen::VectorXd q1 = configuration(path[i]), q2 = configuration(path[next]);
    const std::string effort = effortProblem(i, sweep.steps(q1, q2), sweep.step_m());
    if (!effort.empty()) return effort;
    const auto contact = sweep.firstContact(q1, q2);
    if (!contact) continue;
    const std::string bodies = contact->first + " touches " + contact->second;
    if (contact->fraction == 0.0) return "way-point " + std::to_string(i) + ": " + bodies;
    if (contact->fraction == 1.0) return "way-point " + std::to_string(next) + ": " + bodies;
    return "edge " + std::to_string(i) + " at " + text(contact->fraction) + " of its length: " + bodies;
  }
  return "";
}

}  // namespace b4p::verification
