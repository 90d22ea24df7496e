// SPDX-License-Identifier: BSD-3-Clause
#include "planners/reach/reach_planner.h"

#include <ompl/util/Console.h>

namespace b4p {

namespace ob = ompl::base;

ReachPlanner::ReachPlanner(const ob::SpaceInformationPtr& si, const std::string& name)
    : GuardedPlanner(si, name) {
  specs_.multithreaded = false;

  declareProgress("iterations INTEGER", statistics_.iterations);
  declareProgress("tree nodes INTEGER", statistics_.nodes);
  declareProgress("grasps tried INTEGER", statistics_.grasps_tried);
  declareProgress("ik attempts INTEGER", statistics_.ik_attempts);
  declareProgress("goal roots INTEGER", statistics_.goal_roots);
}

void ReachPlanner::clear() {
  Planner::clear();
  forget();
  problem_.reset();
  goal_.reset();
}

void ReachPlanner::forget() {
  connections_.clear();
  solved_grasp_ = kNoGrasp;
  search_.reset();
  statistics_.reset();
}

ob::PlannerStatus ReachPlanner::search(const ob::PlannerTerminationCondition& ptc) {
  const auto* goal = dynamic_cast<const ReachGoal*>(pdef_->getGoal().get());
  if (goal == nullptr) {
    OMPL_ERROR("%s: the goal has to be a ReachGoal", getName().c_str());
    return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
  }
  if (goal->getSpaceInformation()->getStateSpace() != si_->getStateSpace()) {
    OMPL_ERROR("%s: the goal belongs to another state space", getName().c_str());
    return ob::PlannerStatus::INVALID_GOAL;
  }
  prepareSearch(*goal);
  plantStarts();
  if (search_->forests().treeCount(Side::kPick) == 0) {
    OMPL_ERROR("%s: there is no valid start state", getName().c_str());
    return ob::PlannerStatus::INVALID_START;
  }
  std::optional<Junction> solution = search_->startInGoal();
  while (!solution && !ptc) {
    countOne(statistics_.iterations);
    solution = search_->step();
  }
  if (!solution) return ob::PlannerStatus::TIMEOUT;
  connections_.push_back(*solution);
  solved_grasp_ = goal->graspOf(solution->place->tree->root->state);
  addSolution(pathThrough(*solution, si_).path);
  return ob::PlannerStatus::EXACT_SOLUTION;
}

void ReachPlanner::prepareSearch(const ReachGoal& goal) {
  if (search_ && problem_ == pdef_ && goal_ == pdef_->getGoal()) return;
  forget();
  pis_.restart();
  problem_ = pdef_;
  goal_ = pdef_->getGoal();
  search_ = makeSearch(goal);
}

void ReachPlanner::plantStarts() {
  const GraspAccess grasps(si_);
  while (const ob::State* start = pis_.nextStart()) {
    const JointSpace& joints = search_->goal().joints();
    if (grasps.get(start) != kNoGrasp)
      OMPL_WARN("%s: a start state that holds something is left out", getName().c_str());
    else if (joints.contains(joints.q(start)))
      search_->plantStart(start);
  }
}

void ReachPlanner::getPlannerData(ob::PlannerData& data) const {
  Planner::getPlannerData(data);
  data.properties["grasp id INTEGER"] = std::to_string(solvedGrasp());
  if (!search_) return;
  search_->forests().forEachNode([&data](const Node& node) { addTo(data, node); });
  for (const Junction& junction : connections_) addTo(data, junction);
}

}  // namespace b4p
