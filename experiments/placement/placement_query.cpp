// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/placement_query.h"

#include <utility>

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "experiments/problem.h"
#include "experiments/query.h"
#include "planners/processor_time.h"

namespace b4p {

namespace ob = ompl::base;

namespace {

using Clock = std::chrono::steady_clock;
using StateType = ManipulationStateSpace::StateType;

/// The options that the settings come to. Parameters are set on a planner that nothing is planned with.
std::shared_ptr<PlacementOptions> optionsFrom(const PlacementQuerySettings& settings,
                                              const std::string& where) {
  ompl::msg::noOutputHandler();
  requireTimeLimit(settings.time_limit_s, where, "time limit");
  const auto options = std::make_shared<PlacementOptions>(settings.options);
  makePlanner(placementPlannerKind(options), settings.parameters, settings.threads,
              std::make_shared<ob::SpaceInformation>(std::make_shared<ob::RealVectorStateSpace>(1)), where);
  if (const std::string problem = options->problem(); !problem.empty()) throw InputError(where, "", problem);
  return options;
}

PlacementProblem makeSeededProblem(Scene scene, const PlacementQuerySettings& settings,
                                   const PlacementOptions& options) {
  ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(derivedSeed(settings.seed, 0)));
  if (settings.objective) scene.placing().objective = *settings.objective;
  return makePlacementProblem(scene, options);
}

}  // namespace

PlacementQuery::PlacementQuery(const Scene& scene, const std::string& scene_name,
                               const PlacementQuerySettings& settings, const std::string& where)
    : scene_name_(scene_name),
      settings_(settings),
      options_(optionsFrom(settings, where)),
      problem_(makeSeededProblem(scene, settings, *options_)) {
  const auto prepare = [this](const ob::PlannerTerminationCondition&) {
    improvements_.clear();
    start_ = Clock::now();
    cpu_start_s_ = processTime_s();
  };
  planner_ = std::make_shared<DeadlinePlanner>(
      makePlanner(placementPlannerKind(options_), settings.parameters, settings.threads, problem_.si, where),
      RunLimits{settings.time_limit_s, {}, StopRule::kEither, settings.clock}, prepare, nullptr);
  problem_.setup->setPlanner(planner_);
  problem_.pdef->setIntermediateSolutionCallback([this](const ob::Planner*,
                                                        const std::vector<const ob::State*>& states,
                                                        ob::Cost cost) { keep(states, cost); });
}

void PlacementQuery::check(const PlacementQuerySettings& settings, const std::string& where) {
  optionsFrom(settings, where);
}

void PlacementQuery::keep(const std::vector<const ob::State*>& states, ob::Cost cost) {
  PlacementImprovement& improvement = improvements_.emplace_back();
  improvement.cpu_s = processTime_s() - cpu_start_s_;
  improvement.time_s = settings_.clock == RunClock::kProcessor
                           ? improvement.cpu_s
                           : std::chrono::duration<double>(Clock::now() - start_).count();
  improvement.objective_m = cost.value();
  improvement.arm = states.back()->as<StateType>()->grasp;
  for (const ob::State* state : states) {
    const double* q = state->as<StateType>()->q;
    improvement.path.emplace_back(q, q + problem_.space->dof());
  }
}

PlacementResult PlacementQuery::solve() {
  planner_->setProblemDefinition(problem_.pdef);
  planner_->setup();
  return result(planner_->solve(ob::plannerNonTerminatingCondition()));
}

PlacementResult PlacementQuery::result(const ob::PlannerStatus& status) const {
  PlacementResult result = emptyResult();
  result.improvements = improvements_;
  result.planning_time_s = planner_->elapsed_s();
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
  if (!planner_->crash().empty()) return planner_->crash();
  if (const std::string problem = problem_.goal->problem(); !problem.empty()) return problem;
  if (draws.valid > 0) return "no motion to any of the placements found; " + draws.summary();
  return draws.summary();
}

PlacementResult PlacementQuery::emptyResult() const {
  PlacementResult result;
  result.scene = scene_name_;
  result.objective = nameOf(problem_.scene.placing().objective);
  result.sampling = nameOf(options_->sampling);
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

}  // namespace b4p
