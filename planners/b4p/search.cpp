// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/search.h"

#include <algorithm>
#include <utility>

namespace b4p {

namespace ob = ompl::base;

ForestPair& Search::forestsOf(GraspId grasp) {
  const GraspId key = parameters_.paper ? kNoGrasp : grasp;
  std::lock_guard<std::mutex> lock(forests_mutex_);
  auto& forests = forests_[key];
  if (!forests) {
    // Joins across grasps need an index over all forests; a single pair is its own.
    const bool several = region() != nullptr && !parameters_.paper;
    forests =
        std::make_unique<ForestPair>(si(), grasps().distance(), key, several ? &everywhere_ : nullptr, log());
    incomplete_.push_back(forests.get());
  }
  return *forests;
}

// Inverse kinematics finds the same posture again and again, each time a little off.
bool Search::pickIsPlanted(const ob::State* root, GraspId grasp) {
  constexpr double kSamePosture = 1e-3;  // rad or m
  if (region() == nullptr) return false;
  const Node* near = forestsOf(grasp).nearest(Side::kPick, root);
  return near != nullptr && near->tree->grasp == grasp &&
         grasps().distance()(near->state, root) < kSamePosture;
}

Tree* Search::plant(Side side, const ob::State* root, GraspId grasp, PlacementId placement) {
  if (!allFinite(*si()->getStateSpace(), root)) return nullptr;
  const bool known = side == Side::kPick && pickIsPlanted(root, grasp);
  ForestPair& forests = forestsOf(grasp);
  Tree* tree = known ? nullptr : forests.plant(side, root, grasp, placement);
  // After planting: who has seen the count sees the tree.
  share(log(), [this, side, &forests, planted = tree != nullptr] {
    ++offered_[index(side)];
    if (!planted) return;
    countRoot(side);
    scheduleIfComplete(forests);
  });
  if (tree == nullptr) return nullptr;
  countOne(statistics().roots);
  countOne(statistics().nodes);
  return tree;
}

void Search::scheduleIfComplete(ForestPair& forests) {
  if (!forests.complete()) return;
  const std::lock_guard<std::mutex> lock(forests_mutex_);
  const auto found = std::find(incomplete_.begin(), incomplete_.end(), &forests);
  if (found == incomplete_.end()) return;
  incomplete_.erase(found);
  schedule_.add(&forests);
}

ForestPair* Search::nextUnplaced() {
  const std::lock_guard<std::mutex> lock(forests_mutex_);
  for (std::size_t i = 0; i < incomplete_.size(); ++i) {
    ForestPair* forests = incomplete_.front();
    incomplete_.pop_front();
    incomplete_.push_back(forests);
    if (forests->treeCount(Side::kPick) > 0) return forests;
  }
  return nullptr;
}

void Search::submit(std::shared_ptr<PathRepair> repair) {
  countOne(statistics().repairs_tried);
  share(log(), [this, repair = std::move(repair)] {
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
