// SPDX-License-Identifier: BSD-3-Clause
#include "planners/placement/redirectable_trees.h"

#include <algorithm>
#include <utility>

namespace b4p {

namespace ob = ompl::base;
namespace og = ompl::geometric;

RedirectableTrees::RedirectableTrees(ob::SpaceInformationPtr si, const StateDistance& distance, GraspId grasp)
    : si_(std::move(si)),
      distance_(distance),
      grasp_(grasp),
      symmetric_(si_->getStateSpace()->hasSymmetricInterpolate()) {}

RedirectableTrees::~RedirectableTrees() {
  for (const Node& node : storage_) si_->freeState(const_cast<ob::State*>(node.state));
}

RedirectableTrees::RootedTree& RedirectableTrees::plant(Side side, const ob::State* root) {
  storage_.emplace_back(si_->cloneState(root), nullptr, nullptr);
  RootedTree& tree = trees_.emplace_back();
  tree.side = side;
  tree.grasp = grasp_;
  tree.placement = kNoPlacement;
  tree.root = &storage_.back();
  tree.home = nullptr;
  tree.root->tree = &tree;
  tree.nodes = std::make_shared<Index>();
  tree.nodes->setDistanceFunction(
      [distance = distance_](const Node* a, const Node* b) { return distance(a->state, b->state); });
  tree.nodes->add(tree.root);
  return tree;
}

bool RedirectableTrees::addStart(const ob::State* root) {
  for (const RootedTree& tree : trees_)
    if (tree.side == Side::kPick && si_->equalStates(tree.root->state, root)) return false;
  forward_.push_back(plant(Side::kPick, root).nodes);
  return true;
}

GoalId RedirectableTrees::addGoal(GoalId id, const ob::State* root) {
  RootedTree* tree = findBackward(root);
  if (tree == nullptr) {
    tree = &plant(Side::kPlace, root);
    backward_.push_back(tree);
    ++backward_nodes_;
  }
  if (tree->goal == kNoGoal) {
    tree->goal = id;
    ++goals_;
  }
  return tree->goal;
}

bool RedirectableTrees::removeGoal(GoalId id) {
  RootedTree* tree = findGoal(id);
  if (tree == nullptr) return false;
  tree->goal = kNoGoal;
  --goals_;
  return true;
}

RedirectableTrees::RootedTree* RedirectableTrees::findBackward(const ob::State* root) {
  for (RootedTree* tree : backward_)
    if (si_->equalStates(tree->root->state, root)) return tree;
  return nullptr;
}

RedirectableTrees::RootedTree* RedirectableTrees::findGoal(GoalId id) const {
  if (id == kNoGoal) return nullptr;
  const auto found = std::find_if(backward_.begin(), backward_.end(),
                                  [id](const RootedTree* tree) { return tree->goal == id; });
  return found == backward_.end() ? nullptr : *found;
}

std::vector<GoalId> RedirectableTrees::goals() const {
  std::vector<GoalId> goals;
  for (const RootedTree* tree : backward_)
    if (tree->goal != kNoGoal) goals.push_back(tree->goal);
  return goals;
}

const Node* RedirectableTrees::goalRoot(GoalId id) const {
  const RootedTree* tree = findGoal(id);
  return tree == nullptr ? nullptr : tree->root;
}

const Node* RedirectableTrees::nearest(Side side, const ob::State* state) const {
  const Node query{state, nullptr, nullptr};
  const Node* near = nullptr;
  const auto consider = [&](const Index& nodes) {
    const Node* node = nodes.nearest(&query);
    if (near == nullptr || distance_(node->state, state) < distance_(near->state, state)) near = node;
  };
  if (side == Side::kPick)
    for (const auto& nodes : forward_) consider(*nodes);
  else
    for (const RootedTree* tree : backward_) consider(*tree->nodes);
  return near;
}

const Node* RedirectableTrees::grow(const Node* parent, const ob::State* state) {
  RootedTree& tree = treeOf(parent);
  const Node* node = &storage_.emplace_back(si_->cloneState(state), const_cast<Node*>(parent), &tree);
  tree.nodes->add(node);
  if (tree.side == Side::kPlace) ++backward_nodes_;
  return node;
}

GoalId RedirectableTrees::goalOf(const Junction& junction) const { return treeOf(junction.place).goal; }

std::optional<ReachedGoal> RedirectableTrees::merge(const Junction& junction) {
  RootedTree& joining = treeOf(junction.place);
  RootedTree& forward = treeOf(junction.pick);
  const Node* end = joining.root;
  backward_.erase(std::find(backward_.begin(), backward_.end(), &joining));
  backward_nodes_ -= joining.nodes->size();
  if (symmetric_) {
    auto* parent = const_cast<Node*>(junction.pick);
    for (auto* node = const_cast<Node*>(junction.place); node != nullptr;) {
      Node* next = std::exchange(node->parent, parent);
      parent = node;
      node = next;
    }
    joining.side = Side::kPick;
    joining.root = forward.root;
    shareIndex(joining, forward);
  } else {
    const Node* copy = junction.pick;
    for (const Node* node = junction.place; node != nullptr; node = node->parent)
      copy = grow(copy, node->state);
    end = copy;
  }
  const GoalId goal = std::exchange(joining.goal, kNoGoal);
  if (goal == kNoGoal) return std::nullopt;
  --goals_;
  return ReachedGoal{goal, end};
}

// A tree too large to be moved in the time that a step may take remains an index of its own.
void RedirectableTrees::shareIndex(RootedTree& joining, RootedTree& forward) {
  constexpr std::size_t kMostToMove = 1000;
  if (joining.nodes->size() > kMostToMove) {
    forward_.push_back(joining.nodes);
    return;
  }
  std::vector<const Node*> nodes;
  joining.nodes->list(nodes);
  for (const Node* node : nodes) forward.nodes->add(node);
  joining.nodes = forward.nodes;
}

void RedirectableTrees::forEachNode(const std::function<void(const Node&)>& visit) const {
  for (const Node& node : storage_) visit(node);
}

og::PathGeometric pathTo(const Node& node, const ob::SpaceInformationPtr& si) {
  const Node end{node.state, nullptr, nullptr};
  return pathThrough({&node, &end}, si).path;
}

}  // namespace b4p
