// SPDX-License-Identifier: BSD-3-Clause
#include "planners/reach/reach_planner.h"

#include <exception>

#include <ompl/base/OptimizationObjective.h>
#include <ompl/util/Console.h>

namespace b4p {

namespace ob = ompl::base;
namespace og = ompl::geometric;

ReachPlanner::ReachPlanner(const ob::SpaceInformationPtr& si, const std::string& name)
    : ob::Planner(si, name) {
  specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
  specs_.multithreaded = false;
  specs_.approximateSolutions = false;
  specs_.optimizingPaths = false;
  specs_.directed = true;

  declareProgress("iterations INTEGER", statistics_.iterations);
  declareProgress("tree nodes INTEGER", statistics_.nodes);
  declareProgress("grasps tried INTEGER", statistics_.grasps_tried);
  declareProgress("ik attempts INTEGER", statistics_.ik_attempts);
  declareProgress("goal roots INTEGER", statistics_.goal_roots);
}

void ReachPlanner::declareProgress(const std::string& name, const std::atomic<std::uint64_t>& count) {
  addPlannerProgressProperty(name,
                             [&count] { return std::to_string(count.load(std::memory_order_relaxed)); });
}

void ReachPlanner::clear() {
  Planner::clear();
  connections_.clear();
  search_.reset();
  problem_.reset();
  goal_.reset();
  statistics_.reset();
}

ob::PlannerStatus ReachPlanner::solve(const ob::PlannerTerminationCondition& ptc) {
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
  addSolution(*solution);
  return ob::PlannerStatus::EXACT_SOLUTION;
}

void ReachPlanner::prepareSearch(const ReachGoal& goal) {
  if (search_ && problem_ == pdef_ && goal_ == pdef_->getGoal()) return;
  connections_.clear();
  search_.reset();
  statistics_.reset();
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

void ReachPlanner::addSolution(const Junction& junction) {
  connections_.push_back(junction);
  const auto path = std::make_shared<og::PathGeometric>(pathThrough(junction, si_).path);
  ob::PlannerSolution solution(path);
  solution.setPlannerName(getName());
  if (const auto& objective = pdef_->getOptimizationObjective()) {
    const ob::Cost cost = path->cost(objective);
    solution.setOptimized(objective, cost, objective->isSatisfied(cost));
  }
  pdef_->addSolutionPath(solution);
}

GraspId ReachPlanner::solvedGrasp() const {
  return connections_.empty() ? kNoGrasp : connections_.back().place->tree->placement;
}

void ReachPlanner::getPlannerData(ob::PlannerData& data) const {
  Planner::getPlannerData(data);
  data.properties["grasp id INTEGER"] = std::to_string(solvedGrasp());
  if (!search_) return;
  constexpr int kStartTag = 1, kGoalTag = 2;
  search_->forests().forEachNode([&data](const Node& node) {
    const bool from_start = node.tree->side == Side::kPick;
    const int tag = from_start ? kStartTag : kGoalTag;
    const ob::PlannerDataVertex vertex(node.state, tag);
    if (node.parent == nullptr) {
      from_start ? data.addStartVertex(vertex) : data.addGoalVertex(vertex);
    } else {
      const ob::PlannerDataVertex parent(node.parent->state, tag);
      from_start ? data.addEdge(parent, vertex) : data.addEdge(vertex, parent);
    }
  });
  for (const Junction& junction : connections_)
    data.addEdge(ob::PlannerDataVertex(junction.pick->state), ob::PlannerDataVertex(junction.place->state));
}

}  // namespace b4p
