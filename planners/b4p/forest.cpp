// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/forest.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include <ompl/datastructures/NearestNeighborsGNAT.h>

#include "planners/manipulation_state_space.h"

namespace b4p {

namespace ob = ompl::base;

namespace {

const double* jointsOf(const ob::State* state) { return state->as<ManipulationStateSpace::StateType>()->q; }

}  // namespace

NodeIndex::NodeIndex(const StateDistance& distance, PublicationLog* log) : distance_(distance), log_(log) {
  if (distance.joints() > 0 && distance.joints() <= PointIndex::kMostDimensions) {
    points_ = std::make_unique<PointIndex>(distance.joints());
    return;
  }
  nodes_ = std::make_unique<ompl::NearestNeighborsGNAT<const Node*>>();
  nodes_->setDistanceFunction(
      [distance](const Node* a, const Node* b) { return distance(a->state, b->state); });
}

void NodeIndex::add(const Node* node) {
  if (log_ != nullptr && log_->recording()) {
    if (step_ != log_->step()) unshared_.clear();
    step_ = log_->step();
    unshared_.push_back(node);
  }
  share(log_, [this, node] { insert(node); });
}

void NodeIndex::insert(const Node* node) {
  if (points_) return points_->add(jointsOf(node->state), node);
  std::unique_lock<std::shared_mutex> lock(mutex_);
  nodes_->add(node);
}

const Node* NodeIndex::nearest(const ob::State* state) const {
  const Node* near = nearestShared(state);
  const bool more = log_ != nullptr && log_->recording() && step_ == log_->step();
  return more ? nearerOfThisStep(near, state) : near;
}

const Node* NodeIndex::nearestShared(const ob::State* state) const {
  if (points_) return static_cast<const Node*>(points_->nearest(jointsOf(state)));
  const Node query{state, nullptr, nullptr};
  std::shared_lock<std::shared_mutex> lock(mutex_);
  return nodes_->size() == 0 ? nullptr : nodes_->nearest(&query);
}

const Node* NodeIndex::nearerOfThisStep(const Node* shared, const ob::State* state) const {
  const Node* near = shared;
  for (const Node* node : unshared_)
    if (near == nullptr || distance_(node->state, state) < distance_(near->state, state)) near = node;
  return near;
}

ForestPair::ForestPair(ob::SpaceInformationPtr si, const StateDistance& distance, GraspId grasp,
                       std::array<NodeIndex, 2>* everywhere, PublicationLog* log)
    : si_(std::move(si)),
      grasp_(grasp),
      everywhere_(everywhere),
      log_(log),
      nodes_{NodeIndex(distance, log), NodeIndex(distance, log)} {}

ForestPair::~ForestPair() {
  for (const Node& node : storage_) si_->freeState(const_cast<ob::State*>(node.state));
}

Tree* ForestPair::plant(Side side, const ob::State* root, GraspId grasp, PlacementId placement) {
  std::unique_lock<std::shared_mutex> lock(mutex_);
  if (hasRoot(side, root, grasp)) return nullptr;
  Tree* tree = makeTree(side, root, grasp, placement);
  share(log_, [this, tree] {
    if (hasRoot(tree->side, tree->root->state, tree->grasp)) return;
    trees_[index(tree->side)].push_back(tree);
    join(tree->root);
  });
  return tree;
}

bool ForestPair::hasRoot(Side side, const ob::State* root, GraspId grasp) const {
  const auto& trees = trees_[index(side)];
  return std::any_of(trees.begin(), trees.end(), [&](const Tree* tree) {
    return tree->grasp == grasp && si_->equalStates(tree->root->state, root);
  });
}

Tree* ForestPair::makeTree(Side side, const ob::State* root, GraspId grasp, PlacementId placement) {
  storage_.emplace_back(si_->cloneState(root), nullptr, nullptr);
  Tree* tree = &tree_storage_.emplace_back();
  tree->side = side;
  tree->grasp = grasp;
  tree->placement = placement;
  tree->root = &storage_.back();
  tree->home = this;
  tree->root->tree = tree;
  return tree;
}

const Node* ForestPair::grow(const Node* parent, const ob::State* state) {
  Tree* tree = parent->tree;
  const Node* node = nullptr;
  {
    std::unique_lock<std::shared_mutex> lock(mutex_);
    storage_.emplace_back(si_->cloneState(state), const_cast<Node*>(parent), tree);
    node = &storage_.back();
  }
  tree->size.fetch_add(1, std::memory_order_relaxed);
  join(node);
  return node;
}

void ForestPair::join(const Node* node) {
  const std::size_t side = index(node->tree->side);
  nodes_[side].add(node);
  if (everywhere_ != nullptr) (*everywhere_)[side].add(node);
}

std::size_t ForestPair::treeCount(Side side) const {
  std::shared_lock<std::shared_mutex> lock(mutex_);
  return trees_[index(side)].size();
}

std::vector<Tree*> ForestPair::trees(Side side) const {
  std::shared_lock<std::shared_mutex> lock(mutex_);
  return trees_[index(side)];
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
