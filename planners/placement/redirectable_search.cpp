// SPDX-License-Identifier: BSD-3-Clause
#include "planners/placement/redirectable_search.h"

#include <algorithm>
#include <utility>

#include "planners/b4p/statistics.h"

namespace b4p {

namespace ob = ompl::base;

RedirectableSearch::RedirectableSearch(const ob::SpaceInformationPtr& si, double range, unsigned slice,
                                       PairFilter pairs, RedirectStatistics& statistics)
    : si_(si), slice_(slice), pairs_(std::move(pairs)), statistics_(statistics), motion_(si, range) {}

RedirectableSearch::Mode& RedirectableSearch::modeOf(const ob::State* state) {
  const GraspId grasp = motion_.grasps().get(state);
  for (const auto& mode : modes_)
    if (mode->trees.grasp() == grasp) return *mode;
  return *modes_.emplace_back(std::make_unique<Mode>(si_, motion_.grasps().distance(), grasp));
}

const RedirectableSearch::Mode* RedirectableSearch::modeOf(GoalId id) const {
  for (const auto& mode : modes_)
    if (mode->trees.goalRoot(id) != nullptr) return mode.get();
  return nullptr;
}

bool RedirectableSearch::addStart(const ob::State* start) {
  if (!modeOf(start).trees.addStart(start)) return false;
  countOne(statistics_.nodes);
  return true;
}

GoalId RedirectableSearch::addGoal(const ob::State* goal) {
  const GoalId id = plantGoal(next_goal_, goal);
  if (id != next_goal_) return id;
  ++next_goal_;
  countOne(statistics_.goals);
  return id;
}

void RedirectableSearch::reopen(const ReachedGoal& goal) { plantGoal(goal.id, goal.node->state); }

GoalId RedirectableSearch::plantGoal(GoalId id, const ob::State* root) {
  Mode& mode = modeOf(root);
  const std::size_t nodes_before = mode.trees.nodeCount();
  const GoalId planted = mode.trees.addGoal(id, root);
  statistics_.nodes += mode.trees.nodeCount() - nodes_before;
  if (planted == id) mode.straight.push_back(id);
  return planted;
}

bool RedirectableSearch::removeGoal(GoalId id) {
  return std::any_of(modes_.begin(), modes_.end(),
                     [id](const auto& mode) { return mode->trees.removeGoal(id); });
}

std::vector<GoalId> RedirectableSearch::goals() const {
  std::vector<GoalId> all;
  for (const auto& mode : modes_) {
    const std::vector<GoalId> goals = mode->trees.goals();
    all.insert(all.end(), goals.begin(), goals.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

const ob::State* RedirectableSearch::goalState(GoalId id) const {
  const Mode* mode = modeOf(id);
  return mode == nullptr ? nullptr : mode->trees.goalRoot(id)->state;
}

std::size_t RedirectableSearch::goalCount() const {
  std::size_t count = 0;
  for (const auto& mode : modes_) count += mode->trees.goalCount();
  return count;
}

bool RedirectableSearch::idle() const {
  return std::all_of(modes_.begin(), modes_.end(), [](const auto& mode) { return mode->idle(); });
}

RedirectableSearch::Mode& RedirectableSearch::modeForStep() {
  while (steps_in_turn_ == slice_ || modes_[turn_]->idle()) {
    steps_in_turn_ = 0;
    if (++turn_ < modes_.size()) continue;
    turn_ = 0;
    ++rounds_;
  }
  ++steps_in_turn_;
  return *modes_[turn_];
}

std::optional<ReachedGoal> RedirectableSearch::step() {
  if (idle()) return std::nullopt;
  countOne(statistics_.iterations);
  return grow(modeForStep());
}

std::optional<ReachedGoal> RedirectableSearch::grow(Mode& mode) {
  RedirectableTrees& trees = mode.trees;
  Side side = mode.next_side;
  const ob::State* target = nullptr;
  while (target == nullptr && !mode.straight.empty()) {
    const Node* root = trees.goalRoot(mode.straight.front());
    mode.straight.pop_front();
    if (root == nullptr) continue;
    target = root->state;
    side = Side::kPick;
  }
  if (target == nullptr) {
    target = motion_.sample();
    mode.next_side = opposite(side);
  }
  const Growth growth = growAndConnect(trees, side, target, motion_);
  statistics_.nodes += growth.nodes;
  if (!growth.junction) return std::nullopt;
  const Node* start = growth.junction->pick->tree->root;
  const Node* goal = growth.junction->place->tree->root;
  if (trees.goalOf(*growth.junction) != kNoGoal && !pairs_(start->state, goal->state)) return std::nullopt;
  const std::size_t nodes_before = trees.nodeCount();
  const auto reached = trees.merge(*growth.junction);
  statistics_.nodes += trees.nodeCount() - nodes_before;
  countOne(statistics_.merges);
  return reached;
}

std::size_t RedirectableSearch::startModeCount() const {
  return static_cast<std::size_t>(
      std::count_if(modes_.begin(), modes_.end(), [](const auto& mode) { return mode->trees.hasStarts(); }));
}

std::vector<const RedirectableTrees*> RedirectableSearch::modes() const {
  std::vector<const RedirectableTrees*> modes;
  for (const auto& mode : modes_) modes.push_back(&mode->trees);
  return modes;
}

void RedirectableSearch::forEachNode(const std::function<void(const Node&)>& visit) const {
  for (const auto& mode : modes_) mode->trees.forEachNode(visit);
}

}  // namespace b4p
