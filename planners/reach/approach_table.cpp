// SPDX-License-Identifier: BSD-3-Clause
#include "planners/reach/approach_table.h"

#include <algorithm>

namespace b4p {
namespace {

/// More than are ever of use: each way that fails takes one, and random growth brings new ones.
constexpr std::size_t kKept = 16;

}  // namespace

void ApproachTable::insert(GraspId grasp, double distance, const Node* node) {
  auto& entries = nearest_[static_cast<std::size_t>(grasp)];
  if (entries.size() == kKept) {
    if (distance >= entries.front().first) return;
    entries.erase(entries.begin());
  }
  const auto nearer = [](const Entry& entry, double d) { return entry.first > d; };
  entries.insert(std::lower_bound(entries.begin(), entries.end(), distance, nearer), {distance, node});
}

GraspId ApproachTable::offer(const Node* node, const Eigen::Isometry3d& X_WT, GraspId except) {
  distances_.resize(nearest_.size());
  for (std::size_t i = 0; i < nearest_.size(); ++i) {
    distances_[i] = targets_.distance(static_cast<GraspId>(i), X_WT);
    if (distances_[i] == 0.0) return static_cast<GraspId>(i);
  }
  for (std::size_t i = 0; i < nearest_.size(); ++i)
    if (static_cast<GraspId>(i) != except) insert(static_cast<GraspId>(i), distances_[i], node);
  return kNoGrasp;
}

void ApproachTable::offerTo(GraspId grasp, const Node* node, const Eigen::Isometry3d& X_WT) {
  insert(grasp, targets_.distance(grasp, X_WT), node);
}

GraspId ApproachTable::draw(std::mt19937_64& random, bool weighted) const {
  constexpr double kNearest = 1e-6;  // keeps weights finite
  std::vector<double> weights;
  double sum = 0.0;
  for (const auto& entries : nearest_) {
    weights.push_back(entries.empty() ? 0.0
                      : weighted      ? 1.0 / std::max(kNearest, entries.back().first)
                                      : 1.0);
    sum += weights.back();
  }
  if (sum == 0.0) return kNoGrasp;
  std::discrete_distribution<GraspId> distribution(weights.begin(), weights.end());
  return distribution(random);
}

const Node* ApproachTable::take(GraspId grasp) {
  auto& entries = nearest_[static_cast<std::size_t>(grasp)];
  const Node* node = entries.back().second;
  entries.pop_back();
  return node;
}

}  // namespace b4p
