// SPDX-License-Identifier: BSD-3-Clause
#include "planners/placement/redirectable_rrt_connect.h"

#include <algorithm>
#include <cmath>

#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "planners/parallel_search.h"
#include "planners/place_goal.h"
#include "planners/placement/redirectable_data.h"

namespace b4p {

namespace ob = ompl::base;

std::string RedirectableParameters::problem() const {
  if (!(range >= 0.0) || !std::isfinite(range))
    return "range must be finite and >= 0 (" + std::to_string(range) + ")";
  if (slice < 1) return "slice must be at least 1 (0)";
  return "";
}

RedirectableRRTConnect::RedirectableRRTConnect(const ob::SpaceInformationPtr& si)
    : WithParameters(si, "RedirectableRRTConnect") {
  declare("range", &RedirectableParameters::range, "0.:0.01:10000.");
  declare("slice", &RedirectableParameters::slice, "1:1:100000");
  declareProgress("iterations INTEGER", statistics_.iterations);
  declareProgress("tree nodes INTEGER", statistics_.nodes);
  declareProgress("goals INTEGER", statistics_.goals);
  declareProgress("merged trees INTEGER", statistics_.merges);
}

void RedirectableRRTConnect::clear() {
  Planner::clear();
  forget();
  problem_.reset();
  goal_.reset();
}

void RedirectableRRTConnect::forget() {
  reached_.clear();
  drawer_.reset();
  region_ = nullptr;
  fed_rounds_ = 0;
  search_.reset();
  statistics_.reset();
}

void RedirectableRRTConnect::prepareSearch() {
  checkValidity();
  if (search_ && problem_ == pdef_ && goal_ == pdef_->getGoal()) return;
  forget();
  pis_.restart();
  problem_ = pdef_;
  goal_ = pdef_->getGoal();
  const auto pairs = [goal = goal_.get()](const ob::State* start, const ob::State* end) {
    return goal->isStartGoalPairValid(start, end);
  };
  search_ =
      std::make_unique<RedirectableSearch>(si_, parameters().range, parameters().slice, pairs, statistics_);
  if (const auto* place_goal = dynamic_cast<const PlaceGoal*>(goal_.get())) {
    region_ = &place_goal->region();
    drawer_ = std::make_unique<RootDrawer>(si_, region_, ompl::RNG().getLocalSeed());
  }
}

GoalId RedirectableRRTConnect::addGoal(const ob::State* state) {
  prepareSearch();
  const bool valid =
      allFinite(*si_->getStateSpace(), state) && si_->satisfiesBounds(state) && si_->isValid(state);
  return valid ? search_->addGoal(state) : kNoGoal;
}

bool RedirectableRRTConnect::removeGoal(GoalId id) {
  const auto reached = std::remove_if(reached_.begin(), reached_.end(),
                                      [id](const ReachedGoal& goal) { return goal.id == id; });
  const bool was_reached = reached != reached_.end();
  reached_.erase(reached, reached_.end());
  const bool was_open = search_ && search_->removeGoal(id);
  return was_reached || was_open;
}

std::vector<GoalId> RedirectableRRTConnect::goals() const {
  std::vector<GoalId> goals;
  if (search_) goals = search_->goals();
  for (const ReachedGoal& goal : reached_) goals.push_back(goal.id);
  std::sort(goals.begin(), goals.end());
  goals.erase(std::unique(goals.begin(), goals.end()), goals.end());
  return goals;
}

ob::PlannerStatus RedirectableRRTConnect::search(const ob::PlannerTerminationCondition& ptc) {
  const auto* goal = dynamic_cast<const ob::GoalSampleableRegion*>(pdef_->getGoal().get());
  if (goal == nullptr) {
    OMPL_ERROR("%s: the goal has to be a GoalSampleableRegion", getName().c_str());
    return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
  }
  prepareSearch();
  plantStarts();
  if (region_ == nullptr && search_->startModeCount() == 0) {
    OMPL_ERROR("%s: there is no valid start state", getName().c_str());
    return ob::PlannerStatus::INVALID_START;
  }
  const ob::PlannerStatus planted = plantGoals(*goal, ptc);
  if (planted != ob::PlannerStatus::UNKNOWN) return planted;
  while (!ptc) {
    feed(*goal);
    const auto reached = search_->step();
    if (!reached) continue;
    const auto known = std::find_if(reached_.begin(), reached_.end(),
                                    [&](const ReachedGoal& other) { return other.id == reached->id; });
    known == reached_.end() ? reached_.push_back(*reached) : void(*known = *reached);
    last_reached_ = reached->id;
    addSolution(pathTo(*reached->node, si_));
    return ob::PlannerStatus::EXACT_SOLUTION;
  }
  return ob::PlannerStatus::TIMEOUT;
}

// A pick-and-place problem can do nothing with a grasp it does not know.
void RedirectableRRTConnect::plantStarts() {
  const GraspAccess grasps(si_);
  while (const ob::State* start = pis_.nextStart()) {
    const GraspId grasp = grasps.get(start);
    if (region_ != nullptr && (grasp < 0 || grasp >= region_->graspCount()))
      OMPL_WARN("%s: a start state with the unknown grasp %d is left out", getName().c_str(), grasp);
    else if (allFinite(*si_->getStateSpace(), start))
      search_->addStart(start);
  }
}

bool RedirectableRRTConnect::plantGoal(const ob::State* state) {
  if (state == nullptr || !allFinite(*si_->getStateSpace(), state)) return false;
  search_->addGoal(state);
  return true;
}

// UNKNOWN: there is a goal to search for.
ob::PlannerStatus RedirectableRRTConnect::plantGoals(const ob::GoalSampleableRegion& goal,
                                                     const ob::PlannerTerminationCondition& ptc) {
  if (region_ != nullptr) return ob::PlannerStatus::UNKNOWN;
  while (search_->idle() && !ptc && mayGiveMore(goal)) plantGoal(awaitGoal(ptc));
  if (search_->idle())
    for (const ReachedGoal& reached : reached_) search_->reopen(reached);
  if (!search_->idle()) return ob::PlannerStatus::UNKNOWN;
  if (ptc && mayGiveMore(goal)) return ob::PlannerStatus::TIMEOUT;
  OMPL_ERROR("%s: there is no valid goal state", getName().c_str());
  return ob::PlannerStatus::INVALID_GOAL;
}

void RedirectableRRTConnect::feed(const ob::GoalSampleableRegion& goal) {
  if (region_ != nullptr) {
    if (search_->idle() || search_->rounds() != fed_rounds_) drawRoots();
    fed_rounds_ = search_->rounds();
  } else if (statistics_.goals < statistics_.nodes / 2 && mayGiveMore(goal)) {
    plantGoal(pis_.nextGoal());
  }
}

// One more pick, and one more placement for each grasp whose trees are large enough for it.
void RedirectableRRTConnect::drawRoots() {
  if (drawer_->drawPick() != kNoGrasp) search_->addStart(drawer_->root());
  for (const RedirectableTrees* mode : search_->modes()) {
    if (!mode->hasStarts() || mode->goalCount() > mode->backwardNodeCount() / 2) continue;
    if (drawer_->derivePlaceRoot(drawer_->region().samplePlacement(), mode->grasp()))
      search_->addGoal(drawer_->root());
  }
}

void RedirectableRRTConnect::getPlannerData(ob::PlannerData& data) const {
  Planner::getPlannerData(data);
  if (!search_) return;
  addTo(data, *search_);
  for (const ReachedGoal& goal : reached_) data.markGoalState(goal.node->state);
}

}  // namespace b4p
