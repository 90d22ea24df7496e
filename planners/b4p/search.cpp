// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/search.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace b4p {

namespace ob = ompl::base;
namespace og = ompl::geometric;

Search::Search(ob::SpaceInformationPtr si, const B4PParameters& parameters,
               const ob::GoalSampleableRegion* goal, const PickPlaceRegion* region,
               ob::PlannerInputStates& inputs, Statistics& statistics, PublicationLog* log)
    : si_(std::move(si)),
      parameters_(parameters),
      goal_(goal),
      region_(region),
      grasps_(si_),
      inputs_(inputs),
      statistics_(statistics),
      log_(log),
      everywhere_{NodeIndex(grasps_.distance(), log), NodeIndex(grasps_.distance(), log)} {}

ForestPair& Search::forestsOf(GraspId grasp) {
  const GraspId key = parameters_.paper ? kNoGrasp : grasp;
  std::lock_guard<std::mutex> lock(forests_mutex_);
  auto& forests = forests_[key];
  if (!forests) {
    // Joins across grasps need an index over all forests; a single pair is its own.
    const bool several = region_ != nullptr && !parameters_.paper;
    forests =
        std::make_unique<ForestPair>(si_, grasps_.distance(), key, several ? &everywhere_ : nullptr, log_);
    share(log_, [this, added = forests.get()] { schedule_.add(added); });
  }
  return *forests;
}

namespace {

bool allFinite(const ob::StateSpace& space, const ob::State* state) {
  std::vector<double> reals;
  space.copyToReals(reals, state);
  return std::all_of(reals.begin(), reals.end(), [](double value) { return std::isfinite(value); });
}

}  // namespace

// Inverse kinematics finds the same posture again and again, each time a little off.
bool Search::pickIsPlanted(const ob::State* root, GraspId grasp) {
  constexpr double kSamePosture = 1e-3;  // rad or m
  if (region_ == nullptr) return false;
  const Node* near = forestsOf(grasp).nearest(Side::kPick, root);
  return near != nullptr && near->tree->grasp == grasp &&
         grasps_.distance()(near->state, root) < kSamePosture;
}

Tree* Search::plant(Side side, const ob::State* root, GraspId grasp, PlacementId placement) {
  if (!allFinite(*si_->getStateSpace(), root)) return nullptr;
  const bool known = side == Side::kPick && pickIsPlanted(root, grasp);
  Tree* tree = known ? nullptr : forestsOf(grasp).plant(side, root, grasp, placement);
  // After planting: who has seen the count sees the tree.
  share(log_, [this, side, planted = tree != nullptr] {
    ++offered_[index(side)];
    if (planted) ++roots_[index(side)];
  });
  if (tree == nullptr) return nullptr;
  countOne(statistics_.roots);
  countOne(statistics_.nodes);
  return tree;
}

bool Search::plantGoal() {
  std::lock_guard<std::mutex> lock(inputs_mutex_);
  const ob::State* goal = inputs_.nextGoal();
  return goal != nullptr && plant(Side::kPlace, goal, grasps_.get(goal)) != nullptr;
}

bool Search::rootsMatch(const Junction& junction) const {
  const Tree& pick = *junction.pick->tree;
  const Tree& place = *junction.place->tree;
  return pick.grasp == place.grasp && goal_->isStartGoalPairValid(pick.root->state, place.root->state);
}

void Search::publish(const Junction& junction) {
  share(log_, [this, junction] {
    {
      const std::lock_guard<std::mutex> lock(solution_mutex_);
      connections_.push_back(junction);
    }
    finish(pathThrough(junction, si_).path);
  });
}

void Search::publish(const og::PathGeometric& path) {
  share(log_, [this, path] { finish(path); });
}

std::vector<Junction> Search::connections() const {
  const std::lock_guard<std::mutex> lock(solution_mutex_);
  return connections_;
}

void Search::finish(const og::PathGeometric& path) {
  std::lock_guard<std::mutex> lock(solution_mutex_);
  if (finished_) return;
  solution_ = path;
  finished_.store(true, std::memory_order_release);
}

std::optional<og::PathGeometric> Search::takeSolution() {
  std::lock_guard<std::mutex> lock(solution_mutex_);
  std::optional<og::PathGeometric> solution;
  std::swap(solution, solution_);
  finished_.store(false, std::memory_order_release);
  return solution;
}

void Search::submit(std::shared_ptr<PathRepair> repair) {
  countOne(statistics_.repairs_tried);
  share(log_, [this, repair = std::move(repair)] {
    std::lock_guard<std::mutex> lock(repairs_mutex_);
    repairs_.push_back(repair);
    repairs_waiting_ = repairs_.size();
  });
}

std::shared_ptr<PathRepair> Search::repair() {
  if (repairs_waiting_.load(std::memory_order_relaxed) == 0) return nullptr;
  std::lock_guard<std::mutex> lock(repairs_mutex_);
  return repairs_.empty() ? nullptr : repairs_.front();
}

bool Search::retire(const std::shared_ptr<PathRepair>& repair) {
  std::lock_guard<std::mutex> lock(repairs_mutex_);
  const auto found = std::find(repairs_.begin(), repairs_.end(), repair);
  if (found == repairs_.end()) return false;
  repairs_.erase(found);
  repairs_waiting_ = repairs_.size();
  return true;
}

void Search::forEachNode(const std::function<void(const Node&)>& visit) const {
  std::lock_guard<std::mutex> lock(forests_mutex_);
  for (const auto& [grasp, forests] : forests_) forests->forEachNode(visit);
}

}  // namespace b4p
