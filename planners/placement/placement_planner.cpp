// SPDX-License-Identifier: BSD-3-Clause
#include "planners/placement/placement_planner.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "planners/parallel_search.h"
#include "planners/placement/redirectable_data.h"
#include "planners/shortcuts.h"

namespace b4p {

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

constexpr double kNothing = -std::numeric_limits<double>::infinity();

/// Leads the path's end over `states`, by fewer of them where a straight motion is free.
void lead(og::PathGeometric& path, const std::vector<ob::ScopedState<>>& states,
          const ob::SpaceInformationPtr& si) {
  if (states.empty()) return;
  const ob::State* end = states.back().get();
  const std::size_t count = path.getStateCount();
  if (si->checkMotion(path.getState(static_cast<unsigned>(count - 2)), end)) {
    si->copyState(path.getStates().back(), end);
  } else if (si->checkMotion(path.getStates().back(), end)) {
    path.append(end);
  } else {
    for (const ob::ScopedState<>& state : states) path.append(state.get());
  }
}

}  // namespace

std::string PlacementPlannerParameters::problem() const {
  if (!(range >= 0.0) || !std::isfinite(range))
    return "range must be finite and >= 0 (" + std::to_string(range) + ")";
  if (slice < 1) return "slice must be at least 1 (0)";
  if (iterations < 1) return "iterations must be at least 1 (0)";
  if (draws < 1) return "draws must be at least 1 (0)";
  return LocalOptimisation{local_step, local_steps}.problem();
}

PlacementPlanner::PlacementPlanner(const ob::SpaceInformationPtr& si)
    : WithParameters(si, "PlacementPlanner") {
  specs_.optimizingPaths = true;
  declare("range", &PlacementPlannerParameters::range, "0.:0.01:10000.");
  declare("slice", &PlacementPlannerParameters::slice, "1:1:100000");
  declare("iterations", &PlacementPlannerParameters::iterations, "1:1:100000");
  declare("draws", &PlacementPlannerParameters::draws, "1:1:100000");
  declare("shortcuts", &PlacementPlannerParameters::shortcuts, "0:1:100000");
  declare("local", &PlacementPlannerParameters::local, "0,1");
  declare("local_step", &PlacementPlannerParameters::local_step, "0.0001:0.0001:1.");
  declare("local_steps", &PlacementPlannerParameters::local_steps, "0:1:100000");
  declareProgress("iterations INTEGER", statistics_.iterations);
  declareProgress("tree nodes INTEGER", statistics_.nodes);
  declareProgress("goals INTEGER", statistics_.goals);
  declareProgress("merged trees INTEGER", statistics_.merges);
  declareProgress("placements drawn INTEGER", draws_);
  declareProgress("improvements INTEGER", improvements_);
  declareProgress("local steps INTEGER", local_steps_);
  addPlannerProgressProperty("best objective REAL", [this] {
    const double best = bestObjective();
    return best == kNothing ? std::string("nan") : std::to_string(best);
  });
}

void PlacementPlanner::clear() {
  Planner::clear();
  forget();
  problem_.reset();
  goal_.reset();
}

void PlacementPlanner::forget() {
  if (goal_) goal_->setObjectiveThreshold(threshold_before_);
  starts_seen_ = 0;
  best_path_.reset();
  best_ = kNothing;
  objectives_.clear();
  local_.reset();
  search_.reset();
  ranking_.reset();
  statistics_.reset();
  for (auto* count : {&draws_, &improvements_, &local_steps_}) count->store(0);
}

void PlacementPlanner::prepareSearch(const std::shared_ptr<PlacementGoal>& goal) {
  if (search_ && problem_ == pdef_ && goal_ == goal) return;
  forget();
  pis_.restart();
  problem_ = pdef_;
  goal_ = goal;
  goal_->seed(ompl::RNG().getLocalSeed());
  threshold_before_ = goal_->objectiveThreshold();
  const auto pairs = [goal = goal.get()](const ob::State* start, const ob::State* end) {
    return goal->isStartGoalPairValid(start, end);
  };
  const PlacementPlannerParameters& p = parameters();
  search_ = std::make_unique<RedirectableSearch>(si_, p.range, p.slice, pairs, statistics_);
  local_ = std::make_unique<LocalOptimiser>(si_, *goal_, LocalOptimisation{p.local_step, p.local_steps});
  ranking_ = std::dynamic_pointer_cast<PlacementPathObjective>(pdef_->getOptimizationObjective());
  if (!ranking_) ranking_ = std::make_shared<PlacementPathObjective>(si_, goal_);
}

ob::PlannerStatus PlacementPlanner::search(const ob::PlannerTerminationCondition& ptc) {
  const auto goal = std::dynamic_pointer_cast<PlacementGoal>(pdef_->getGoal());
  if (!goal) {
    OMPL_ERROR("%s: the goal has to be a PlacementGoal", getName().c_str());
    return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
  }
  if (goal->getSpaceInformation()->getStateSpace() != si_->getStateSpace()) {
    OMPL_ERROR("%s: the goal belongs to another state space", getName().c_str());
    return ob::PlannerStatus::INVALID_GOAL;
  }
  prepareSearch(goal);
  plantStarts();
  if (search_->startModeCount() == 0) {
    OMPL_ERROR("%s: there is no valid start state of an arm", getName().c_str());
    return ob::PlannerStatus::INVALID_START;
  }
  if (best_path_ && !pdef_->hasSolution()) publish(*best_path_, bestObjective());
  while (!ptc && !ranking_->isSatisfied(ob::Cost(bestObjective()))) {
    const bool sampled = sampleGoal(ptc);
    if (!problem().empty() || (!sampled && search_->idle() && !goal_->couldSample())) break;
    if (const auto reached = planMotion(ptc)) take(*reached, ptc);
  }
  return status();
}

/// What went wrong with the world or the objective, be it asked by the goal or by local optimisation.
std::string PlacementPlanner::problem() const {
  return goal_->objective().failed() ? goal_->objective().problem() : goal_->problem();
}

ob::PlannerStatus PlacementPlanner::status() const {
  const std::string why = problem();
  if (!why.empty() && draws_ > 0) throw std::runtime_error(why);
  if (best_path_) return ob::PlannerStatus::EXACT_SOLUTION;
  if (goal_->couldSample()) return ob::PlannerStatus::TIMEOUT;
  OMPL_ERROR("%s: %s", getName().c_str(), why.empty() ? "there is no placement" : why.c_str());
  return ob::PlannerStatus::INVALID_GOAL;
}

// Not through PlannerInputStates: that asks the validity checker of states with an unknown arm as well.
void PlacementPlanner::plantStarts() {
  const GraspAccess arms(si_);
  for (; starts_seen_ < pdef_->getStartStateCount(); ++starts_seen_) {
    const ob::State* start = pdef_->getStartState(starts_seen_);
    const GraspId arm = arms.get(start);
    if (arm < 0 || arm >= goal_->world().armCount())
      OMPL_WARN("%s: a start state with the unknown arm %d is left out", getName().c_str(), arm);
    else if (allFinite(*si_->getStateSpace(), start) && si_->satisfiesBounds(start) && si_->isValid(start))
      search_->addStart(start);
    else
      OMPL_WARN("%s: the start state of arm %d is not valid", getName().c_str(), arm);
  }
}

// One draw at a time, so that the time limit is kept.
bool PlacementPlanner::sampleGoal(const ob::PlannerTerminationCondition& ptc) {
  ob::ScopedState<> state(si_);
  for (unsigned i = 0; i < parameters().draws && !ptc && goal_->couldSample(); ++i) {
    countOne(draws_);
    if (!goal_->sample(state.get(), 1) || !si_->isValid(state.get())) continue;
    const GoalId id = search_->addGoal(state.get());
    objectives_[id] = goal_->objective(state.get());
    return true;
  }
  return false;
}

std::optional<ReachedGoal> PlacementPlanner::planMotion(const ob::PlannerTerminationCondition& ptc) {
  for (unsigned i = 0; i < parameters().iterations && !search_->idle() && !ptc; ++i)
    if (const auto reached = search_->step()) return reached;
  return std::nullopt;
}

void PlacementPlanner::take(const ReachedGoal& reached, const ob::PlannerTerminationCondition& ptc) {
  og::PathGeometric path = pathTo(*reached.node, si_);
  double objective = objectives_.at(reached.id);
  objectives_.erase(reached.id);
  if (parameters().local) {
    const LocalOptimiser::Result better = local_->improve(reached.node->state, objective, ptc);
    local_steps_ += better.states.size();
    lead(path, better.states, si_);
    if (!better.states.empty()) goal_->reportReached(path.getStates().back(), better.objective);
    objective = better.objective;
  }
  if (!(objective > bestObjective())) return;
  takeShortcuts(path, parameters().shortcuts, ptc);
  best_path_ = path;
  best_ = objective;
  countOne(improvements_);
  goal_->setObjectiveThreshold(objective);
  publish(path, objective);
  dropGoalsNoBetter();
}

void PlacementPlanner::publish(const og::PathGeometric& path, double objective) {
  const auto published = std::make_shared<og::PathGeometric>(path);
  ob::PlannerSolution solution(published);
  solution.setPlannerName(getName());
  solution.setOptimized(ranking_, ob::Cost(objective), ranking_->isSatisfied(ob::Cost(objective)));
  pdef_->addSolutionPath(solution);
  const auto& callback = pdef_->getIntermediateSolutionCallback();
  if (!callback) return;
  const std::vector<const ob::State*> states(published->getStates().begin(), published->getStates().end());
  callback(this, states, ob::Cost(objective));
}

void PlacementPlanner::dropGoalsNoBetter() {
  for (auto goal = objectives_.begin(); goal != objectives_.end();) {
    if (goal->second > bestObjective()) {
      ++goal;
    } else {
      search_->removeGoal(goal->first);
      goal = objectives_.erase(goal);
    }
  }
}

void PlacementPlanner::getPlannerData(ob::PlannerData& data) const {
  Planner::getPlannerData(data);
  if (search_) addTo(data, *search_);
}

}  // namespace b4p
