// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/forest.h"

#include <mutex>
#include <utility>

#include <ompl/datastructures/NearestNeighborsGNAT.h>

namespace b4p {

namespace ob = ompl::base;

NodeIndex::NodeIndex(const StateDistance& distance) : nodes_(new ompl::NearestNeighborsGNAT<const Node*>) {
  nodes_->setDistanceFunction(
      [distance](const Node* a, const Node* b) { return distance(a->state, b->state); });
}

void NodeIndex::add(const Node* node) {
  std::unique_lock<std::shared_mutex> lock(mutex_);
  nodes_->add(node);
}

const Node* NodeIndex::nearest(const ob::State* state) const {
  const Node query{state, nullptr, nullptr};
  std::shared_lock<std::shared_mutex> lock(mutex_);
  return nodes_->size() == 0 ? nullptr : nodes_->nearest(&query);
}

ForestPair::ForestPair(ob::SpaceInformationPtr si, const StateDistance& distance, GraspId grasp,
                       std::array<NodeIndex, 2>* everywhere)
    : si_(std::move(si)),
      grasp_(grasp),
      everywhere_(everywhere),
      nodes_{NodeIndex(distance), NodeIndex(distance)} {}

ForestPair::~ForestPair() {
  for (const Node& node : storage_) si_->freeState(const_cast<ob::State*>(node.state));
}

Tree* ForestPair::plant(Side side, const ob::State* root, GraspId grasp, PlacementId placement) {
  Tree* tree = nullptr;
  {
    std::unique_lock<std::shared_mutex> lock(mutex_);
    auto& trees = trees_[index(side)];
    for (const Tree& present : trees)
      if (present.grasp == grasp && si_->equalStates(present.root->state, root)) return nullptr;
    storage_.push_back(Node{si_->cloneState(root), nullptr, nullptr});
    trees.emplace_back();
    tree = &trees.back();
    tree->side = side;
    tree->grasp = grasp;
    tree->placement = placement;
    tree->root = &storage_.back();
    tree->home = this;
    tree->root->tree = tree;
  }
  nodes_[index(side)].add(tree->root);
  if (everywhere_ != nullptr) (*everywhere_)[index(side)].add(tree->root);
  return tree;
}

const Node* ForestPair::grow(const Node* parent, const ob::State* state) {
  Tree* tree = parent->tree;
  const Node* node = nullptr;
  {
    std::unique_lock<std::shared_mutex> lock(mutex_);
    storage_.push_back(Node{si_->cloneState(state), const_cast<Node*>(parent), tree});
    node = &storage_.back();
  }
  tree->size.fetch_add(1, std::memory_order_relaxed);
  nodes_[index(tree->side)].add(node);
  if (everywhere_ != nullptr) (*everywhere_)[index(tree->side)].add(node);
  return node;
}

std::size_t ForestPair::treeCount(Side side) const {
  std::shared_lock<std::shared_mutex> lock(mutex_);
  return trees_[index(side)].size();
}

std::vector<Tree*> ForestPair::trees(Side side) const {
  std::shared_lock<std::shared_mutex> lock(mutex_);
  std::vector<Tree*> trees;
  for (const Tree& tree : trees_[index(side)]) trees.push_back(const_cast<Tree*>(&tree));
  return trees;
}

std::size_t ForestPair::nodeCount() const {
  std::shared_lock<std::shared_mutex> lock(mutex_);
  return storage_.size();
}

void ForestPair::forEachNode(const std::function<void(const Node&)>& visit) const {
  std::shared_lock<std::shared_mutex> lock(mutex_);
  for (const Node& node : storage_) visit(node);
}

}  // namespace b4p
