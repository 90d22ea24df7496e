// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/certification/grasp_examiner.h"

#include <utility>

#include "experiments/certification/planar/planar_scene.h"
#include "experiments/certification/single_grasp_plan.h"
#include "experiments/interrupt.h"
#include "experiments/verification/verifier.h"
#include "planners/processor_time.h"

namespace b4p {
namespace {

enum Stream : std::uint64_t { kGraspStream, kEachGraspStream };
enum GraspStream : std::uint64_t { kPickStream, kPlaceStream, kPlanStream };

constexpr int kPickDraws = 8;
constexpr std::size_t kPostures = 4;  ///< picks that planning starts from: an arm's postures differ
constexpr double kMostCells = 1e9;    ///< two bits each

std::string outcomeText(RootOutcome outcome, const std::string& collision) {
  switch (outcome) {
    case RootOutcome::kValid:
      return "";
    case RootOutcome::kUnreachable:
      return "no inverse kinematics";
    case RootOutcome::kGripperCollides:
    case RootOutcome::kArmCollides:
      break;
  }
  if (!collision.empty()) return "collision " + collision;
  return outcome == RootOutcome::kArmCollides ? "the arm collides" : "gripper or object collide";
}

std::vector<Grasp> drawnGrasps(const Scene& scene, const Manipulator& robot, int count, std::uint64_t seed) {
  const auto sampler = makeGraspSampler(scene.pickPlace().grasps, robot.description().max_opening_m);
  return drawGrasps(*sampler, count, derivedSeed(seed, kGraspStream));
}

}  // namespace

GraspExaminer::GraspExaminer(const Scene& scene, CertificateSettings settings)
    : settings_(std::move(settings)),
      problem_(makeProblem(scene)),
      why_no_proof_(planar::whyNotPlanar(*problem_.robot)),
      grasps_(drawnGrasps(scene, *problem_.robot, settings_.grasps, settings_.seed)) {}

std::uint64_t GraspExaminer::seedOf(int id) const {
  return derivedSeed(derivedSeed(settings_.seed, kEachGraspStream), static_cast<std::uint64_t>(id));
}

Problem GraspExaminer::problemOf(int id) const {
  return withGraspsOnly(problem_, {grasps_.at(static_cast<std::size_t>(id))});
}

std::vector<std::vector<double>> GraspExaminer::picks(int id, std::string& failure) const {
  const Problem problem = problemOf(id);
  const auto context = problem.region->makeSceneContext(derivedSeed(seedOf(id), kPickStream));
  std::vector<std::vector<double>> found;
  failure.clear();
  for (int draw = 0; draw < kPickDraws && found.size() < kPostures && !interrupted(); ++draw) {
    std::vector<double> q(static_cast<std::size_t>(problem.robot->dof()));
    std::string collision;
    const RootOutcome outcome = context->tryPick(0, q.data(), collision);
    if (outcome == RootOutcome::kValid)
      found.push_back(std::move(q));
    else if (failure.empty() || outcome == RootOutcome::kArmCollides)
      failure = outcomeText(outcome, collision);
  }
  if (!found.empty()) failure.clear();
  return found;
}

void GraspExaminer::countPlacements(Examination& examination) const {
  const int id = examination.record.id;
  const Problem problem = problemOf(id);
  const auto context = problem.region->makeSceneContext(derivedSeed(seedOf(id), kPlaceStream));
  std::vector<double> q(static_cast<std::size_t>(problem.robot->dof()));
  for (int draw = 0; draw < settings_.placement_draws && !interrupted(); ++draw) {
    const RootOutcome outcome = context->tryPlacement(0, q.data());
    if (outcome == RootOutcome::kValid)
      ++examination.record.placements_found;
    else
      ++examination.placement_failures[outcomeText(outcome, "")];
  }
}

bool GraspExaminer::proveBlocked(GraspRecord& record, std::size_t first_grid, std::size_t last_grid) const {
  if (!why_no_proof_.empty()) return false;
  const planar::PlanarTask task = planar::planarTask(problem_.scene, *problem_.robot, record.grasp);
  for (std::size_t i = first_grid; i < last_grid; ++i) {
    const planar::GridSize& size = settings_.grids[i];
    if (planar::gridOf(task, size).cells() > kMostCells) return false;
    const auto outcome = planar::floodFromStart(task, size, interrupted);
    if (!outcome) return false;
    if (!outcome->blocked) continue;
    record.status = GraspStatus::kBlocked;
    record.grid = size;
    return true;
  }
  return false;
}

void GraspExaminer::plan(const std::vector<std::vector<double>>& starts, Examination& examination) const {
  GraspRecord& record = examination.record;
  Problem problem = problemOf(record.id);
  PlanResult result =
      planWithOneGrasp(problem, starts, derivedSeed(seedOf(record.id), kPlanStream), settings_.effort_s);
  record.checks = problem.motions->configurationsChecked();
  if (!result.solved) return;
  result.grasp_id = record.id;
  result.verification = verify(problem_.scene, result);
  record.failure = result.verification.failure;
  if (!result.verification.passed) return;
  record.status = GraspStatus::kCompatible;
  record.clearance_m = result.verification.clearance_m;
  examination.path = std::move(result);
}

Examination GraspExaminer::examine(int id) const {
  const double begin_s = threadTime_s();
  const std::size_t grids = settings_.grids.size(), coarse = grids - (grids > 0 ? 1 : 0);
  Examination examination;
  GraspRecord& record = examination.record;
  record.id = id;
  record.grasp = grasps_.at(static_cast<std::size_t>(id));
  const auto starts = picks(id, examination.pick_failure);
  if (!starts.empty()) {
    countPlacements(examination);
    record.status = record.placements_found > 0 ? GraspStatus::kUndecided : GraspStatus::kNoPlacement;
    // The finest cells cost more than planning does.
    if (!proveBlocked(record, 0, coarse)) {
      if (record.placements_found > 0) plan(starts, examination);
      if (record.status == GraspStatus::kUndecided) proveBlocked(record, coarse, grids);
    }
  }
  record.seconds = threadTime_s() - begin_s;
  return examination;
}

}  // namespace b4p
