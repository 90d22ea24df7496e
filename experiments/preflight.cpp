// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/preflight.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "experiments/floating_body.h"
#include "experiments/placement/placement_problem.h"
#include "robots/input_error.h"

namespace b4p {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr int kGraspDraws = 400;
constexpr int kEnoughGrasps = 20;
constexpr int kPlacementDraws = 400;

/// The clearance that the scene states is checked like any collision, of an object grown by it.
void requireObjectClear(const Problem& problem) {
  constexpr double kRounding_m = 1e-6;
  const Scene& scene = problem.scene;
  CollisionProblem grown = problem.checker->problem();
  grown.padding_m = std::max(scene.edge_step_m / 2.0, scene.pickPlace().contact_clearance_m - kRounding_m);
  FloatingBody object(*FloatingBody::makeChecker(grown, FloatingBody::Parts::kObject, *problem.checker));
  const std::string collision = object.describeCollision(scene.pickPlace().X_WO_start, Grasp());
  if (!collision.empty())
    throw InputError(scene.file, "object.start",
                     "is nearer to an obstacle (" + collision + ") than contact_clearance_m, " +
                         std::to_string(scene.pickPlace().contact_clearance_m) + " m");
}

/// Tally of why grasps drawn are of no use.
struct Failures {
  std::map<std::string, int> reasons;

  void add(RootOutcome outcome, const std::string& collision) {
    if (outcome == RootOutcome::kUnreachable) ++reasons["no inverse kinematics"];
    if (outcome == RootOutcome::kGripperCollides || outcome == RootOutcome::kArmCollides)
      ++reasons["collision " + collision];
  }

  std::string commonest() const {
    const auto most = std::max_element(reasons.begin(), reasons.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most == reasons.end()) return "";
    return ", most often: " + most->first + " (" + std::to_string(most->second) + ")";
  }
};

std::vector<Grasp> validGrasps(const Problem& problem, SceneRegionContext& context) {
  std::vector<Grasp> valid;
  Failures failures;
  for (int draw = 0; draw < kGraspDraws && static_cast<int>(valid.size()) < kEnoughGrasps; ++draw) {
    Grasp grasp;
    std::string collision;
    const RootOutcome outcome = context.probePick(grasp, collision);
    if (outcome == RootOutcome::kValid) valid.push_back(grasp);
    failures.add(outcome, collision);
  }
  if (valid.empty())
    throw InputError(problem.scene.file, "grasps",
                     "none of " + std::to_string(kGraspDraws) + " grasps drawn is valid at the start pose" +
                         failures.commonest());
  return valid;
}

void requireReachableRegion(const Problem& problem, SceneRegionContext& context,
                            const std::vector<Grasp>& grasps) {
  for (std::size_t draw = 0; draw < kPlacementDraws; ++draw)
    if (context.reachesSomePlacement(grasps[draw % grasps.size()])) return;
  throw InputError(problem.scene.file, "placement.region",
                   "is unreachable: no inverse kinematics for any of " + std::to_string(kPlacementDraws) +
                       " placements drawn with " + std::to_string(grasps.size()) +
                       " grasps valid at the start pose");
}

}  // namespace

void preflight(const Scene& scene) {
  if (scene.kind() == TaskKind::kPlacement)
    makePlacementProblem(scene);
  else
    makePlanningProblem(scene)->requireSolvable();
}

void requirePickAndPlaceSolvable(const Problem& problem) {
  requireObjectClear(problem);
  const auto context = problem.region->makeSceneContext(kSeed);
  requireReachableRegion(problem, *context, validGrasps(problem, *context));
}

}  // namespace b4p
