// SPDX-License-Identifier: BSD-3-Clause
#include "planners/guarded_planner.h"

#include <exception>
#include <memory>

#include <ompl/base/OptimizationObjective.h>
#include <ompl/util/Console.h>

#include "planners/place_goal.h"

namespace b4p {

namespace ob = ompl::base;
namespace og = ompl::geometric;

GuardedPlanner::GuardedPlanner(const ob::SpaceInformationPtr& si, const std::string& name)
    : ob::Planner(si, name) {
  specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
  specs_.approximateSolutions = false;
  specs_.optimizingPaths = false;
  specs_.directed = true;
}

ob::PlannerStatus GuardedPlanner::solve(const ob::PlannerTerminationCondition& ptc) {
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

void GuardedPlanner::declareProgress(const std::string& name, const std::atomic<std::uint64_t>& count) {
  addPlannerProgressProperty(name,
                             [&count] { return std::to_string(count.load(std::memory_order_relaxed)); });
}

void GuardedPlanner::addSolution(const og::PathGeometric& path) {
  const auto solution_path = std::make_shared<og::PathGeometric>(path);
  ob::PlannerSolution solution(solution_path);
  solution.setPlannerName(getName());
  if (const auto& objective = pdef_->getOptimizationObjective()) {
    const ob::Cost cost = solution_path->cost(objective);
    solution.setOptimized(objective, cost, objective->isSatisfied(cost));
  }
  pdef_->addSolutionPath(solution);
}

void GuardedPlanner::checkValidityOfDrawnStarts() {
  const bool draws_its_starts = pdef_ && dynamic_cast<const PlaceGoal*>(pdef_->getGoal().get()) != nullptr;
  if (!draws_its_starts) return Planner::checkValidity();
  if (!isSetup()) setup();
}

// Listed goals that have all been taken do not become more; sampled ones may, as long as the goal could
// sample.
bool GuardedPlanner::mayGiveMore(const ob::GoalSampleableRegion& goal) const {
  const bool listed =
      goal.hasType(ob::GOAL_STATE) || (goal.hasType(ob::GOAL_STATES) && !goal.hasType(ob::GOAL_LAZY_SAMPLES));
  return pis_.haveMoreGoalStates() || (!listed && goal.couldSample());
}

// Without a condition of its own, nextGoal() gives up instead of waiting for goals that never come.
const ob::State* GuardedPlanner::awaitGoal(const ob::PlannerTerminationCondition& ptc) {
  return pis_.haveMoreGoalStates() ? pis_.nextGoal() : pis_.nextGoal(ptc);
}

void addTo(ob::PlannerData& data, const Node& node) {
  const bool pick = node.tree->side == Side::kPick;
  const ob::PlannerDataVertex vertex(node.state, pick ? kPickTag : kPlaceTag);
  if (node.parent == nullptr) {
    pick ? data.addStartVertex(vertex) : data.addGoalVertex(vertex);
  } else {
    const ob::PlannerDataVertex parent(node.parent->state, pick ? kPickTag : kPlaceTag);
    pick ? data.addEdge(parent, vertex) : data.addEdge(vertex, parent);
  }
}

void addTo(ob::PlannerData& data, const Junction& junction) {
  data.addEdge(ob::PlannerDataVertex(junction.pick->state), ob::PlannerDataVertex(junction.place->state));
}

}  // namespace b4p
