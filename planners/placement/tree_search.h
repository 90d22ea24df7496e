// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <functional>
#include <queue>
#include <vector>

#include "planners/placement/afr_hierarchy.h"
#include "planners/placement/placement_sampler.h"

namespace b4p {

/// Monte Carlo tree search over the AFR hierarchy (paper, Algorithms 2 and 3), with UCB1 and the rewards of
/// PlacementReward. What it has learnt stays over all thresholds.
///
/// With options.prune, branches whose bound does not exceed the threshold are closed: nothing in them can be
/// better. With options.discount below 1, visits and rewards fade whenever the threshold rises, because
/// rewards earned under a lower one say too much.
class TreeSearch : public PlacementSampler {
 public:
  TreeSearch(const PlacementWorld& world, const PlacementObjective& objective,
             const PlacementOptions& options);

  bool draw(std::mt19937_64& random, double threshold, Placement& placement, Branch& branch) override;
  void learn(Branch branch, const PlacementOutcome& outcome) override;
  void learnReached(const Placement& placement) override;
  void thresholdRaised(double threshold) override;

  std::size_t size() const { return nodes_.size(); }

 private:
  struct Learnt {
    double visits = 0.0, rewards = 0.0;
  };

  struct Child {
    Branch branch;
    Learnt learnt;  ///< a copy of the child's own, where all children can be compared at once
  };

  struct Node {
    AfrNode afr;
    Branch parent = -1;
    std::size_t place = 0;  ///< among the parent's children
    Learnt learnt;
    double bound = 0.0;  ///< of the objective; known when `bounded`
    bool bounded = false;
    bool expanded = false;     ///< `untried` has been filled
    std::vector<int> untried;  ///< numbers of children that are not in the tree
    std::vector<Child> children;
  };

  /// A draw that has been better than the threshold so far.
  struct Better {
    double objective;
    Branch branch;
    double surplus;  ///< of its reward over that of a draw that is no better, over `faded_` at that time
    bool operator>(const Better& other) const { return objective > other.objective; }
  };

  Node& node(Branch branch) { return nodes_[static_cast<std::size_t>(branch)]; }
  void expand(Branch branch);
  Branch addChild(Branch branch, std::size_t place);
  Branch addRandomChild(Branch branch, std::mt19937_64& random);
  bool open(Branch branch, double threshold);
  /// Whether a draw goes on to a child: always above the regions, below them from nodes that have been drawn
  /// from, while the tree may grow or need not.
  bool descends(Branch branch);
  Branch selectChild(Branch branch, double threshold, std::mt19937_64& random);
  double rewardOf(const PlacementOutcome& outcome, bool leaf) const;
  void add(Branch branch, const Learnt& more);

  const PlacementObjective& objective_;
  PlacementOptions options_;
  AfrHierarchy hierarchy_;
  std::deque<Node> nodes_;                                                   ///< node 0 is the root
  std::priority_queue<Better, std::vector<Better>, std::greater<>> better_;  ///< least objective on top
  double faded_ = 1.0;                                                       ///< product of all discounts
};

}  // namespace b4p
