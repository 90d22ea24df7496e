// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/query.h"

#include <cmath>
#include <utility>

#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "robots/input_error.h"

namespace b4p {

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

enum Stream : std::uint64_t { kOmplStream, kGoalStream, kStartStream };

/// OMPL says, as an error, that seeding comes too late for those generators that exist already; those of this
/// query do not yet.
std::unique_ptr<PlanningProblem> makeSeededProblem(const Scene& scene, CheckerKind checker,
                                                   std::uint64_t seed) {
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(derivedSeed(seed, kOmplStream)));
  auto problem = makePlanningProblem(scene, checker);
  problem->seedGoal(derivedSeed(seed, kGoalStream));
  return problem;
}

}  // namespace

Query::Query(const Scene& scene, const std::string& scene_name, const PlannerCatalogue& catalogue,
             const QuerySettings& settings, const std::string& where)
    : scene_name_(scene_name),
      settings_(settings),
      problem_(makeSeededProblem(scene, settings.checker, settings.seed)) {
  requireTimeLimit(settings.time_limit_s, where, "time limit");
  const PlannerKind& kind = findFitting(catalogue, settings.planner, scene, where);
  const auto prepare = [this, starts = kind.start_states](const ob::PlannerTerminationCondition& done) {
    configurations_ = problem_->motions->configurationsChecked();
    edge_checks_ = problem_->counts->edges;
    problem_->plantStarts(starts, derivedSeed(settings_.seed, kStartStream), done);
  };
  // Until the run ends, configurations_ is where the counter stood when it began.
  const auto checked = [this] { return problem_->motions->configurationsChecked() - configurations_; };
  const auto finish = [this, checked] {
    configurations_ = checked();
    edge_checks_ = problem_->counts->edges - edge_checks_;
  };
  planner_ = std::make_shared<DeadlinePlanner>(
      makePlanner(kind, settings.parameters, settings.threads, problem_->si, where),
      RunLimits{settings.time_limit_s, settings.check_limit, settings.stop, settings.clock}, prepare, finish,
      checked);
  problem_->setup->setPlanner(planner_);
}

void Query::solve() {
  planner_->setProblemDefinition(problem_->pdef);
  planner_->setup();
  status_ = planner_->solve(ob::plannerNonTerminatingCondition());
}

PlanResult Query::result(const ob::PlannerStatus& status) const {
  PlanResult result = pathResult(*problem_, status);
  result.scene = scene_name_;
  result.planner = settings_.planner;
  result.checker = checkerName(settings_.checker);
  planner_->params().getParams(result.parameters);
  result.seed = settings_.seed;
  result.threads = settings_.threads;
  result.time_limit_s = settings_.time_limit_s;
  result.planning_time_s = planner_->elapsed_s();
  return result;
}

PlanResult pathResult(const PlanningProblem& problem, const ob::PlannerStatus& status) {
  PlanResult result;
  result.status = status.asString();
  for (const int joint : problem.robot->plannedJoints())
    result.joint_names.push_back(problem.robot->model().joints[static_cast<std::size_t>(joint)].name);
  result.solved = status == ob::PlannerStatus::EXACT_SOLUTION && problem.pdef->hasExactSolution();
  if (!result.solved) return result;

  using StateType = ManipulationStateSpace::StateType;
  const auto& path = *problem.pdef->getSolutionPath()->as<og::PathGeometric>();
  const auto dof = static_cast<std::ptrdiff_t>(problem.space->dof());
  for (std::size_t i = 0; i < path.getStateCount(); ++i) {
    const double* q = path.getState(static_cast<unsigned>(i))->as<StateType>()->q;
    result.path.emplace_back(q, q + dof);
  }
  problem.interpret(path, result);
  return result;
}

bool crashed(const PlanResult& result) {
  return result.status == ob::PlannerStatus(ob::PlannerStatus::CRASH).asString();
}

void requireTimeLimit(double time_limit_s, const std::string& where, const std::string& element) {
  if (!(time_limit_s > 0.0) || !std::isfinite(time_limit_s))
    throw InputError(where, element,
                     "has to be a positive number of seconds (" + std::to_string(time_limit_s) + ")");
}

}  // namespace b4p
