// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/placement_query.h"

#include <array>
#include <chrono>
#include <utility>

#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "experiments/interrupt.h"
#include "experiments/problem.h"
#include "robots/input_error.h"

namespace b4p {

namespace ob = ompl::base;

namespace {

using Clock = std::chrono::steady_clock;
using StateType = ManipulationStateSpace::StateType;

template <class Value>
struct Named {
  Value value;
  const char* name;
};

constexpr std::array<Named<ClearanceGoal>, 2> kGoals{
    {{ClearanceGoal::kLargest, "max_clearance"}, {ClearanceGoal::kSmallest, "min_clearance"}}};
constexpr std::array<Named<PlacementSampling>, 3> kSamplings{
    {{PlacementSampling::kTreeSearch, "tree"},
     {PlacementSampling::kUniformChildren, "children"},
     {PlacementSampling::kUniformArea, "area"}}};

template <class Names>
auto valueOf(const Names& names, const std::string& name, const std::string& where,
             const std::string& element) {
  std::string known;
  for (const auto& named : names) {
    if (name == named.name) return named.value;
    known += (known.empty() ? "" : ", ") + std::string(named.name);
  }
  throw InputError(where, element, "'" + name + "' is unknown; there are: " + known);
}

template <class Names, class Value>
std::string nameIn(const Names& names, Value value) {
  for (const auto& named : names)
    if (named.value == value) return named.name;
  return {};
}

PlacementProblem makeSeededProblem(Scene scene, const PlacementQuerySettings& settings) {
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(derivedSeed(settings.seed, 0)));
  if (settings.objective) scene.placing().objective = *settings.objective;
  return makePlacementProblem(scene, settings.options);
}

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

PlacementQuery::PlacementQuery(const Scene& scene, const std::string& scene_name,
                               const PlacementQuerySettings& settings, const std::string& where)
    : scene_name_(scene_name), settings_(settings), problem_(makeSeededProblem(scene, settings)) {
  const PlannerKind kind{"place", "", 0, [](const ob::SpaceInformationPtr& si) {
                           return std::make_shared<PlacementPlanner>(si);
                         }};
  planner_ = std::static_pointer_cast<PlacementPlanner>(
      makePlanner(kind, settings.parameters, 1, problem_.si, where));
  planner_->setProblemDefinition(problem_.pdef);
}

PlacementResult PlacementQuery::solve() {
  PlacementResult result = emptyResult();
  const Clock::time_point start = Clock::now();
  problem_.pdef->setIntermediateSolutionCallback(
      [&](const ob::Planner*, const std::vector<const ob::State*>& states, ob::Cost cost) {
        PlacementImprovement& improvement = result.improvements.emplace_back();
        improvement.time_s = secondsSince(start);
        improvement.objective_m = cost.value();
        improvement.arm = states.back()->as<StateType>()->grasp;
        for (const ob::State* state : states) {
          const double* q = state->as<StateType>()->q;
          improvement.path.emplace_back(q, q + problem_.space->dof());
        }
      });
  planner_->setup();
  const ob::PlannerStatus status = planner_->solve(ob::PlannerTerminationCondition(
      [&] { return interrupted() || secondsSince(start) >= settings_.time_limit_s; }));
  problem_.pdef->setIntermediateSolutionCallback({});
  result.planning_time_s = secondsSince(start);
  result.status = status.asString();
  result.draws = problem_.goal->statistics();
  const auto context = problem_.world->makeContext();
  for (PlacementImprovement& improvement : result.improvements)
    improvement.X_WO = context->objectPose(improvement.arm, improvement.path.back().data());
  if (!result.solved()) result.reason = reason(result.draws);
  return result;
}

/// Which test rejected the draws, or why there were none.
std::string PlacementQuery::reason(const PlacementStatistics& draws) const {
  if (!planner_->lastError().empty()) return planner_->lastError();
  if (const std::string problem = problem_.goal->problem(); !problem.empty()) return problem;
  if (draws.valid > 0) return "no motion to any of the placements found; " + draws.summary();
  return draws.summary();
}

PlacementResult PlacementQuery::emptyResult() const {
  PlacementResult result;
  result.scene = scene_name_;
  result.objective = nameOf(problem_.scene.placing().objective);
  result.sampling = nameOf(settings_.options.sampling);
  planner_->params().getParams(result.parameters);
  result.seed = settings_.seed;
  result.time_limit_s = settings_.time_limit_s;
  for (std::size_t i = 0; i < problem_.world->arms().size(); ++i) {
    const Manipulator& robot = *problem_.world->arms()[i].robot;
    result.arms.push_back(problem_.scene.placing().arms[i].name);
    std::vector<std::string>& names = result.joint_names.emplace_back();
    for (const int joint : robot.plannedJoints())
      names.push_back(robot.model().joints[static_cast<std::size_t>(joint)].name);
  }
  return result;
}

ClearanceGoal clearanceGoal(const std::string& name, const std::string& where) {
  return valueOf(kGoals, name, where, "--objective");
}

PlacementSampling placementSampling(const std::string& name, const std::string& where) {
  return valueOf(kSamplings, name, where, "--sampling");
}

std::string nameOf(ClearanceGoal goal) { return nameIn(kGoals, goal); }
std::string nameOf(PlacementSampling sampling) { return nameIn(kSamplings, sampling); }

}  // namespace b4p
