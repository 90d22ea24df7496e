// SPDX-License-Identifier: BSD-3-Clause
#include "planners/parallel_planner.h"

#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "planners/b4p/crew.h"
#include "planners/place_goal.h"

namespace b4p {

namespace ob = ompl::base;

ParallelPlanner::ParallelPlanner(const ob::SpaceInformationPtr& si, const std::string& name)
    : GuardedPlanner(si, name) {
  specs_.multithreaded = true;

  declareProgress("iterations INTEGER", statistics_.iterations);
  declareProgress("roots INTEGER", statistics_.roots);
  declareProgress("tree nodes INTEGER", statistics_.nodes);
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

void ParallelPlanner::checkValidity() { checkValidityOfDrawnStarts(); }

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
    search_->resume();
    work([this](std::size_t number) { workers_[number]->step(); },
         [this] { return search_->finished() || search_->expired(); }, ptc);
    search_->pause();
    if (auto solution = search_->takeSolution()) {
      shorten(*solution, ptc);
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
  const PickPlaceRegion* region = place_goal != nullptr ? &place_goal->region() : nullptr;
  search_ = makeSearch({si_, &goal, region, pis_, statistics_, publicationLog()});
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

bool ParallelPlanner::plantFirstGoal(const ob::GoalSampleableRegion& goal,
                                     const ob::PlannerTerminationCondition& ptc) {
  while (search_->rootCount(Side::kPlace) == 0 && !ptc && mayGiveMore(goal)) {
    const ob::State* state = awaitGoal(ptc);
    if (state != nullptr) search_->addRoot(Side::kPlace, state, search_->grasps().get(state));
  }
  return search_->rootCount(Side::kPlace) > 0;
}

void ParallelPlanner::work(const std::function<void(std::size_t)>& step, const std::function<bool()>& over,
                           const ob::PlannerTerminationCondition& ptc) {
  runCrew(threadCount(), [&](std::size_t number, const std::atomic<bool>& stop) {
    while (!stop && !over() && !ptc) step(number);
  });
}

void ParallelPlanner::getPlannerData(ob::PlannerData& data) const {
  Planner::getPlannerData(data);
  if (!search_) return;
  search_->forEachNode([&data](const Node& node) { addTo(data, node); });
  for (const Junction& junction : search_->connections()) addTo(data, junction);
}

}  // namespace b4p
