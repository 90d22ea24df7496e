// SPDX-License-Identifier: BSD-3-Clause
#include "planners/parallel_planner.h"

#include <exception>

#include <ompl/base/OptimizationObjective.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "planners/b4p/crew.h"
#include "planners/place_goal.h"

namespace b4p {

namespace ob = ompl::base;
namespace og = ompl::geometric;

ParallelPlanner::ParallelPlanner(const ob::SpaceInformationPtr& si, const std::string& name)
    : ob::Planner(si, name) {
  specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
  specs_.multithreaded = true;
  specs_.approximateSolutions = false;
  specs_.optimizingPaths = false;
  specs_.directed = true;

  declareProgress("iterations INTEGER", statistics_.iterations);
  declareProgress("roots INTEGER", statistics_.roots);
  declareProgress("tree nodes INTEGER", statistics_.nodes);
}

void ParallelPlanner::declareProgress(const std::string& name, const std::atomic<std::uint64_t>& count) {
  addPlannerProgressProperty(name,
                             [&count] { return std::to_string(count.load(std::memory_order_relaxed)); });
}

void ParallelPlanner::clear() {
  Planner::clear();
  forget();
  problem_.reset();
  goal_.reset();
}

void ParallelPlanner::forget() {
  workers_.clear();
  search_.reset();
  statistics_.reset();
}

void ParallelPlanner::checkValidity() {
  const bool draws_its_starts = pdef_ && dynamic_cast<const PlaceGoal*>(pdef_->getGoal().get()) != nullptr;
  if (!draws_its_starts) return Planner::checkValidity();
  if (!isSetup()) setup();
}

ob::PlannerStatus ParallelPlanner::solve(const ob::PlannerTerminationCondition& ptc) {
  checkValidity();
  last_error_.clear();
  try {
    return search(ptc);
  } catch (const std::exception& e) {
    last_error_ = e.what();
  } catch (...) {
    last_error_ = "an exception of unknown type";
  }
  OMPL_ERROR("%s: stopped by %s", getName().c_str(), last_error_.c_str());
  return ob::PlannerStatus::CRASH;
}

ob::PlannerStatus ParallelPlanner::search(const ob::PlannerTerminationCondition& ptc) {
  const auto* goal = dynamic_cast<const ob::GoalSampleableRegion*>(pdef_->getGoal().get());
  if (goal == nullptr) {
    OMPL_ERROR("%s: the goal has to be a GoalSampleableRegion", getName().c_str());
    return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
  }
  prepareSearch(*goal);
  for (;;) {
    const ob::PlannerStatus planted = plantRoots(*goal, ptc);
    if (planted != ob::PlannerStatus::UNKNOWN) return planted;
    work(ptc);
    if (const auto solution = search_->takeSolution()) {
      addSolution(*solution);
      return ob::PlannerStatus::EXACT_SOLUTION;
    }
    if (ptc || !search_->expired()) return ob::PlannerStatus::TIMEOUT;
    countOne(statistics_.restarts);
    beginSearch(*goal);
    hireWorkers();
  }
}

void ParallelPlanner::prepareSearch(const ob::GoalSampleableRegion& goal) {
  if (!search_ || problem_ != pdef_ || goal_ != pdef_->getGoal()) {
    forget();
    problem_ = pdef_;
    goal_ = pdef_->getGoal();
    beginSearch(goal);
  }
  for (const auto& worker : workers_) worker->rest();  // there may be fewer threads this time
  hireWorkers();
}

void ParallelPlanner::beginSearch(const ob::GoalSampleableRegion& goal) {
  workers_.clear();
  search_.reset();
  statistics_.nodes = 0;
  pis_.restart();
  const auto* place_goal = dynamic_cast<const PlaceGoal*>(&goal);
  search_ =
      makeSearch({si_, &goal, place_goal != nullptr ? &place_goal->region() : nullptr, pis_, statistics_});
}

// Each worker's random streams derive from OMPL's seed in this order, never from the order in which threads
// start.
void ParallelPlanner::hireWorkers() {
  while (workers_.size() < threadCount()) workers_.push_back(search_->newWorker(ompl::RNG().getLocalSeed()));
}

// UNKNOWN: the search has what it needs to begin.
ob::PlannerStatus ParallelPlanner::plantRoots(const ob::GoalSampleableRegion& goal,
                                              const ob::PlannerTerminationCondition& ptc) {
  plantStarts();
  if (search_->region() != nullptr) return ob::PlannerStatus::UNKNOWN;
  if (search_->rootCount(Side::kPick) == 0) {
    OMPL_ERROR("%s: there is no valid start state", getName().c_str());
    return ob::PlannerStatus::INVALID_START;
  }
  if (plantFirstGoal(goal, ptc)) return ob::PlannerStatus::UNKNOWN;
  if (ptc && mayGiveMore(goal)) return ob::PlannerStatus::TIMEOUT;
  OMPL_ERROR("%s: there is no valid goal state", getName().c_str());
  return ob::PlannerStatus::INVALID_GOAL;
}

// A pick-and-place problem can do nothing with a grasp it does not know.
void ParallelPlanner::plantStarts() {
  while (const ob::State* start = pis_.nextStart()) {
    const GraspId grasp = search_->grasps().get(start);
    const PickPlaceRegion* region = search_->region();
    if (region != nullptr && (grasp < 0 || grasp >= region->graspCount()))
      OMPL_WARN("%s: a start state with the unknown grasp %d is left out", getName().c_str(), grasp);
    else
      search_->addRoot(Side::kPick, start, grasp);
  }
}

// Listed goals that have all been taken do not become more; sampled ones may, as long as the goal could
// sample.
bool ParallelPlanner::mayGiveMore(const ob::GoalSampleableRegion& goal) const {
  const bool listed =
      goal.hasType(ob::GOAL_STATE) || (goal.hasType(ob::GOAL_STATES) && !goal.hasType(ob::GOAL_LAZY_SAMPLES));
  return pis_.haveMoreGoalStates() || (!listed && goal.couldSample());
}

bool ParallelPlanner::plantFirstGoal(const ob::GoalSampleableRegion& goal,
                                     const ob::PlannerTerminationCondition& ptc) {
  while (search_->rootCount(Side::kPlace) == 0 && !ptc && mayGiveMore(goal)) {
    // Without a condition of its own, nextGoal() gives up instead of waiting for goals that never come.
    const ob::State* state = pis_.haveMoreGoalStates() ? pis_.nextGoal() : pis_.nextGoal(ptc);
    if (state != nullptr) search_->addRoot(Side::kPlace, state, search_->grasps().get(state));
  }
  return search_->rootCount(Side::kPlace) > 0;
}

void ParallelPlanner::work(const ob::PlannerTerminationCondition& ptc) {
  search_->resume();
  runCrew(threadCount(), [&](std::size_t number, const std::atomic<bool>& stop) {
    while (!stop && !search_->finished() && !search_->expired() && !ptc) workers_[number]->step();
  });
  search_->pause();
}

void ParallelPlanner::addSolution(const og::PathGeometric& path) {
  const auto solution_path = std::make_shared<og::PathGeometric>(path);
  ob::PlannerSolution solution(solution_path);
  solution.setPlannerName(getName());
  if (const auto& objective = pdef_->getOptimizationObjective()) {
    const ob::Cost cost = solution_path->cost(objective);
    solution.setOptimized(objective, cost, objective->isSatisfied(cost));
  }
  pdef_->addSolutionPath(solution);
}

void ParallelPlanner::getPlannerData(ob::PlannerData& data) const {
  Planner::getPlannerData(data);
  if (!search_) return;
  constexpr int kPickTag = 1, kPlaceTag = 2;
  search_->forEachNode([&data](const Node& node) {
    const bool pick = node.tree->side == Side::kPick;
    const ob::PlannerDataVertex vertex(node.state, pick ? kPickTag : kPlaceTag);
    if (node.parent == nullptr) {
      pick ? data.addStartVertex(vertex) : data.addGoalVertex(vertex);
    } else {
      const ob::PlannerDataVertex parent(node.parent->state, pick ? kPickTag : kPlaceTag);
      pick ? data.addEdge(parent, vertex) : data.addEdge(vertex, parent);
    }
  });
  for (const Junction& junction : search_->connections())
    data.addEdge(ob::PlannerDataVertex(junction.pick->state), ob::PlannerDataVertex(junction.place->state));
}

}  // namespace b4p
