// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/query_export/solved_roots.h"

#include <cstddef>

#include "experiments/verification/collision_sweep.h"
#include "experiments/verification/kinematics.h"
#include "experiments/verification/number_text.h"
#include "experiments/verification/path_checks.h"

namespace b4p {
namespace {

using verification::CollisionSweep;
using verification::Kinematics;
using verification::text;

constexpr int kDraws = 4;  ///< of seeds of the inverse kinematics, per root
constexpr double kPosition_m = 1e-4, kAngle_rad = 1e-3;

enum Stream : std::uint64_t { kPickStream, kPlaceStream };

std::string nameOf(const SolvedRoot& root) {
  const std::string grasp = "grasp " + std::to_string(root.grasp);
  return root.placement == kNoPlacement
             ? "pick root of " + grasp
             : "root of " + grasp + " at placement " + std::to_string(root.placement);
}

/// What is wrong with where the object is, and the joints.
std::string poseProblem(const Kinematics& robot, const Grasp& grasp, const Eigen::Isometry3d& X_WO,
                        const std::vector<double>& q) {
  for (int i = 0; i < robot.dof(); ++i) {
    const double value = q[static_cast<std::size_t>(i)];
    if (!(value >= robot.plannedJoint(i).lower && value <= robot.plannedJoint(i).upper))
      return robot.plannedJoint(i).name + " at " + text(value) + " is outside its limits";
  }
  const Eigen::Isometry3d X = verification::objectPose(robot, grasp, q);
  const double off_m = (X.translation() - X_WO.translation()).norm();
  const double off_rad = Eigen::AngleAxisd(X.linear().transpose() * X_WO.linear()).angle();
  if (!(off_m <= kPosition_m) || !(off_rad <= kAngle_rad))
    return "the object is " + text(off_m) + " m and " + text(off_rad) + " rad off";
  return "";
}

}  // namespace

SolvedRoots solveRoots(const Problem& problem, int placements, int most_places, std::uint64_t seed) {
  const SceneRegion& region = *problem.region;
  SolvedRoots roots;
  std::vector<double> q(static_cast<std::size_t>(problem.robot->dof()));
  const auto picking = region.makeSceneContext(derivedSeed(seed, kPickStream));
  for (GraspId grasp = 0; grasp < region.graspCount(); ++grasp)
    for (int draw = 0; draw < kDraws; ++draw)
      if (picking->pickRoot(grasp, q.data())) {
        roots.picks.push_back({grasp, kNoPlacement, q});
        break;
      }
  const auto placing = region.makeSceneContext(derivedSeed(seed, kPlaceStream));
  for (int i = 0; i < placements; ++i)
    roots.placements.push_back(region.placement(placing->samplePlacement()));
  for (PlacementId placement = 0; placement < placements; ++placement)
    for (const SolvedRoot& pick : roots.picks) {
      if (static_cast<int>(roots.places.size()) == most_places) return roots;
      ++roots.pairs_tried;
      for (int draw = 0; draw < kDraws; ++draw)
        if (placing->placeRoot(placement, pick.grasp, q.data())) {
          roots.places.push_back({pick.grasp, placement, q});
          break;
        }
    }
  return roots;
}

std::string rootsProblem(const Problem& problem, const SolvedRoots& roots) {
  const Scene& scene = problem.scene;
  const Kinematics robot(scene.robot.urdf_file, scene.robot.description, scene.X_WB);
  for (const auto* list : {&roots.picks, &roots.places})
    for (const SolvedRoot& root : *list) {
      const Grasp& grasp = problem.region->grasp(root.grasp);
      const Eigen::Isometry3d& X_WO = root.placement == kNoPlacement
                                          ? scene.pickPlace().X_WO_start
                                          : roots.placements[static_cast<std::size_t>(root.placement)];
      std::string wrong = poseProblem(robot, grasp, X_WO, root.q);
      CollisionSweep sweep(scene, robot, grasp, scene.edge_step_m);
      if (wrong.empty()) wrong = verification::motionProblem({root.q}, sweep);
      if (!wrong.empty()) return nameOf(root) + ": " + wrong;
    }
  return "";
}

}  // namespace b4p
