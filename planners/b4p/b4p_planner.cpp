// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/b4p_planner.h"

#include <exception>
#include <string>
#include <utility>

#include <ompl/base/OptimizationObjective.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

#include "planners/b4p/crew.h"
#include "planners/place_goal.h"

namespace b4p {

namespace ob = ompl::base;
namespace og = ompl::geometric;

B4P::B4P(const ob::SpaceInformationPtr& si) : ob::Planner(si, "B4P") {
  specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
  specs_.multithreaded = true;
  specs_.approximateSolutions = false;
  specs_.optimizingPaths = false;
  specs_.directed = true;

  declare("threads", &B4PParameters::threads, "1:1:64");
  declare("paper", &B4PParameters::paper, "0,1");
  declare("pick_roots", &B4PParameters::pick_roots, "1:1:1024");
  declare("place_roots", &B4PParameters::place_roots, "1:1:1024");
  declare("relaxed", &B4PParameters::relaxed, "0,1");
  declare("repair", &B4PParameters::repair, "0,1");
  declare("range", &B4PParameters::range, "0.:0.01:10000.");
  declare("slice", &B4PParameters::slice, "1:1:100000");
  declare("root_attempts", &B4PParameters::root_attempts, "1:1:10000");
  declare("repair_iterations", &B4PParameters::repair_iterations, "1:1:100000");

  declareProgress("iterations INTEGER", statistics_.iterations);
  declareProgress("roots INTEGER", statistics_.roots);
  declareProgress("tree nodes INTEGER", statistics_.nodes);
  declareProgress("connections tried INTEGER", statistics_.connections_tried);
  declareProgress("repairs tried INTEGER", statistics_.repairs_tried);
  declareProgress("repairs succeeded INTEGER", statistics_.repairs_succeeded);
}

B4P::~B4P() = default;

template <class Value>
void B4P::declare(const std::string& name, Value B4PParameters::*field, const std::string& range) {
  const auto set = [this, field](Value value) {
    B4PParameters changed = parameters_;
    changed.*field = value;
    setParameters(changed);
  };
  params_.declareParam<Value>(name, set, [this, field] { return parameters_.*field; });
  params_[name].setRangeSuggestion(range);
}

void B4P::declareProgress(const std::string& name, const std::atomic<std::uint64_t>& count) {
  addPlannerProgressProperty(name,
                             [&count] { return std::to_string(count.load(std::memory_order_relaxed)); });
}

void B4P::setParameters(const B4PParameters& parameters) {
  const std::string problem = parameters.problem();
  if (!problem.empty()) throw ompl::Exception(getName(), problem);
  parameters_ = parameters;
}

void B4P::clear() {
  Planner::clear();
  workers_.clear();
  search_.reset();
  problem_.reset();
  goal_.reset();
  statistics_.reset();
}

void B4P::checkValidity() {
  const bool draws_its_starts = pdef_ && dynamic_cast<const PlaceGoal*>(pdef_->getGoal().get()) != nullptr;
  if (!draws_its_starts) return Planner::checkValidity();
  if (!isSetup()) setup();
}

ob::PlannerStatus B4P::solve(const ob::PlannerTerminationCondition& ptc) {
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

ob::PlannerStatus B4P::search(const ob::PlannerTerminationCondition& ptc) {
  auto* goal = dynamic_cast<ob::GoalSampleableRegion*>(pdef_->getGoal().get());
  if (goal == nullptr) {
    OMPL_ERROR("%s: the goal has to be a GoalSampleableRegion", getName().c_str());
    return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
  }
  prepareSearch(goal);
  plantStarts();
  if (search_->region() == nullptr) {
    if (search_->rootCount(Side::kPick) == 0) {
      OMPL_ERROR("%s: there is no valid start state", getName().c_str());
      return ob::PlannerStatus::INVALID_START;
    }
    if (!plantFirstGoal(*goal, ptc)) {
      if (ptc && mayGiveMore(*goal)) return ob::PlannerStatus::TIMEOUT;
      OMPL_ERROR("%s: there is no valid goal state", getName().c_str());
      return ob::PlannerStatus::INVALID_GOAL;
    }
  }
  work([this](std::size_t number) { workers_[number]->step(); }, [this] { return search_->finished(); }, ptc);
  const auto solution = search_->takeSolution();
  if (!solution) return ob::PlannerStatus::TIMEOUT;
  addSolution(*solution);
  return ob::PlannerStatus::EXACT_SOLUTION;
}

void B4P::prepareSearch(ob::GoalSampleableRegion* goal) {
  if (!search_ || problem_ != pdef_ || goal_ != pdef_->getGoal()) {
    workers_.clear();
    statistics_.reset();
    pis_.restart();
    problem_ = pdef_;
    goal_ = pdef_->getGoal();
    const auto* place_goal = dynamic_cast<const PlaceGoal*>(goal);
    search_ = std::make_unique<Search>(si_, parameters_, goal,
                                       place_goal != nullptr ? &place_goal->region() : nullptr, pis_,
                                       statistics_, publicationLog());
  }
  for (const auto& worker : workers_) worker->rest();  // there may be fewer threads this time
  // Each worker's random streams derive from OMPL's seed in this order, never from the order in which threads
  // start.
  while (workers_.size() < parameters_.threads)
    workers_.push_back(makeWorker(*search_, ompl::RNG().getLocalSeed()));
}

// A pick-and-place problem can do nothing with a grasp it does not know.
void B4P::plantStarts() {
  while (const ob::State* start = pis_.nextStart()) {
    const GraspId grasp = search_->grasps().get(start);
    const PickPlaceRegion* region = search_->region();
    if (region != nullptr && (grasp < 0 || grasp >= region->graspCount()))
      OMPL_WARN("%s: a start state with the unknown grasp %d is left out", getName().c_str(), grasp);
    else
      search_->plant(Side::kPick, start, grasp);
  }
}

// Listed goals that have all been taken do not become more; sampled ones may, as long as the goal could
// sample.
bool B4P::mayGiveMore(const ob::GoalSampleableRegion& goal) const {
  const bool listed =
      goal.hasType(ob::GOAL_STATE) || (goal.hasType(ob::GOAL_STATES) && !goal.hasType(ob::GOAL_LAZY_SAMPLES));
  return pis_.haveMoreGoalStates() || (!listed && goal.couldSample());
}

bool B4P::plantFirstGoal(const ob::GoalSampleableRegion& goal, const ob::PlannerTerminationCondition& ptc) {
  while (search_->rootCount(Side::kPlace) == 0 && !ptc && mayGiveMore(goal)) {
    // Without a condition of its own, nextGoal() gives up instead of waiting for goals that never come.
    const ob::State* state = pis_.haveMoreGoalStates() ? pis_.nextGoal() : pis_.nextGoal(ptc);
    if (state != nullptr) search_->plant(Side::kPlace, state, search_->grasps().get(state));
  }
  return search_->rootCount(Side::kPlace) > 0;
}

void B4P::work(const std::function<void(std::size_t)>& step, const std::function<bool()>& finished,
               const ob::PlannerTerminationCondition& ptc) {
  runCrew(parameters_.threads, [&](std::size_t number, const std::atomic<bool>& stop) {
    while (!stop && !finished() && !ptc) step(number);
  });
}

void B4P::addSolution(const og::PathGeometric& path) {
  const auto solution_path = std::make_shared<og::PathGeometric>(path);
  ob::PlannerSolution solution(solution_path);
  solution.setPlannerName(getName());
  if (const auto& objective = pdef_->getOptimizationObjective()) {
    const ob::Cost cost = solution_path->cost(objective);
    solution.setOptimized(objective, cost, objective->isSatisfied(cost));
  }
  pdef_->addSolutionPath(solution);
}

void B4P::getPlannerData(ob::PlannerData& data) const {
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
