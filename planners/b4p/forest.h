// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <shared_mutex>
#include <vector>

#include <ompl/base/SpaceInformation.h>
#include <ompl/datastructures/NearestNeighbors.h>

#include "planners/b4p/publication_log.h"
#include "planners/nearest/point_index.h"
#include "planners/nearest/state_distance.h"
#include "planners/pick_place_region.h"

namespace b4p {

enum class Side { kPick = 0, kPlace = 1 };
inline Side opposite(Side side) { return side == Side::kPick ? Side::kPlace : Side::kPick; }
inline std::size_t index(Side side) { return static_cast<std::size_t>(side); }

struct Tree;
class ForestPair;

/// A configuration in a tree, joined to its parent by a motion that is free under the tree's grasp.
struct Node {
  const ompl::base::State* state;
  Node* parent;  ///< nullptr for a root
  Tree* tree;
  mutable std::atomic<std::uint8_t> trapped{0};  ///< how often it could not move, as far as that is counted

  Node(const ompl::base::State* at, Node* below, Tree* of) : state(at), parent(below), tree(of) {}
};

/// What has grown from one root. Place roots remember the object placement they were derived from.
struct Tree {
  Side side;
  GraspId grasp;
  PlacementId placement;
  Node* root;
  ForestPair* home;
  std::atomic<std::size_t> size{1};
  std::atomic<bool> has_retreated{false};  ///< its root's straight ways out have been tried
  std::atomic<unsigned> way_out{0};        ///< nodes on the longest of them
};

/// Nearest neighbours among nodes. Any thread may add or ask; by the distance of joints, in a PointIndex,
/// asking takes no lock. With a log, a step finds the nodes that it added itself before others do.
class NodeIndex {
 public:
  explicit NodeIndex(const StateDistance& distance, PublicationLog* log = nullptr);
  void add(const Node* node);
  /// nullptr while empty.
  const Node* nearest(const ompl::base::State* state) const;

 private:
  void insert(const Node* node);
  const Node* nearestShared(const ompl::base::State* state) const;
  const Node* nearerOfThisStep(const Node* shared, const ompl::base::State* state) const;

  StateDistance distance_;
  PublicationLog* log_;
  std::vector<const Node*> unshared_;  ///< added by the step of this number, when there is a log
  std::uint64_t step_ = 0;
  std::unique_ptr<PointIndex> points_;  ///< nullptr: `nodes_` instead
  mutable std::shared_mutex mutex_;     // guards what follows
  std::unique_ptr<ompl::NearestNeighbors<const Node*>> nodes_;
};

/// A pick forest and a place forest that grow toward each other. Nodes only ever join; any thread may add or
/// ask.
class ForestPair {
 public:
  /// @param grasp       the grasp all its trees share, or kNoGrasp when they may differ
  /// @param everywhere  further indices (pick, place) that every node joins; may be nullptr
  /// @param log         keeps trees and nodes from being seen before their time; may be nullptr
  ForestPair(ompl::base::SpaceInformationPtr si, const StateDistance& distance, GraspId grasp,
             std::array<NodeIndex, 2>* everywhere = nullptr, PublicationLog* log = nullptr);
  ~ForestPair();
  ForestPair(const ForestPair&) = delete;
  ForestPair& operator=(const ForestPair&) = delete;

  GraspId grasp() const { return grasp_; }

  /// Starts a tree from a copy of `root`. nullptr when this side has an equal root with this grasp already.
  /// With a log the tree joins later, unless an equal one has joined meanwhile.
  Tree* plant(Side side, const ompl::base::State* root, GraspId grasp, PlacementId placement);

  /// Adds a copy of `state` below `parent`.
  const Node* grow(const Node* parent, const ompl::base::State* state);

  /// Nearest node of a side, whatever its tree; nullptr while there is none.
  const Node* nearest(Side side, const ompl::base::State* state) const {
    return nodes_[index(side)].nearest(state);
  }

  std::size_t treeCount(Side side) const;
  /// Both sides have a root.
  bool complete() const { return treeCount(Side::kPick) > 0 && treeCount(Side::kPlace) > 0; }
  std::vector<Tree*> trees(Side side) const;  ///< a snapshot
  std::size_t nodeCount() const;
  void forEachNode(const std::function<void(const Node&)>& visit) const;

 private:
  bool hasRoot(Side side, const ompl::base::State* root, GraspId grasp) const;
  Tree* makeTree(Side side, const ompl::base::State* root, GraspId grasp, PlacementId placement);
  void join(const Node* node);

  ompl::base::SpaceInformationPtr si_;
  GraspId grasp_;
  std::array<NodeIndex, 2>* everywhere_;
  PublicationLog* log_;
  std::array<NodeIndex, 2> nodes_;
  mutable std::shared_mutex mutex_;  // guards what follows
  std::deque<Node> storage_;
  std::deque<Tree> tree_storage_;
  std::array<std::vector<Tree*>, 2> trees_;
};

}  // namespace b4p
