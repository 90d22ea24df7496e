// SPDX-License-Identifier: BSD-3-Clause
#include "planners/placement/tree_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace b4p {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr double kDrawsBeforeBound = 8.0;
constexpr double kFadedAway = 1e-100;       ///< what is left of rewards counts for nothing
constexpr std::size_t kMostNodes = 500000;  ///< about 100 MB

}  // namespace

TreeSearch::TreeSearch(const PlacementWorld& world, const PlacementObjective& objective,
                       const PlacementOptions& options)
    : objective_(objective), options_(options), hierarchy_(world), nodes_(1) {}

void TreeSearch::expand(Branch branch) {
  Node& n = node(branch);
  if (n.expanded) return;
  n.expanded = true;
  n.untried.resize(static_cast<std::size_t>(hierarchy_.childCount(n.afr)));
  std::iota(n.untried.begin(), n.untried.end(), 0);
}

TreeSearch::Branch TreeSearch::addChild(Branch branch, std::size_t place) {
  Node& n = node(branch);
  const auto child = static_cast<Branch>(nodes_.size());
  Node added;
  added.afr = hierarchy_.child(n.afr, n.untried[place]);
  added.parent = branch;
  std::swap(n.untried[place], n.untried.back());
  n.untried.pop_back();
  added.place = n.children.size();
  n.children.push_back({child, {}});
  nodes_.push_back(std::move(added));
  return child;
}

TreeSearch::Branch TreeSearch::addRandomChild(Branch branch, std::mt19937_64& random) {
  const int count = static_cast<int>(node(branch).untried.size());
  return addChild(branch, static_cast<std::size_t>(indexDraw(random, count)));
}

bool TreeSearch::open(Branch branch, double threshold) {
  if (!options_.prune || threshold == -kInfinity) return true;
  Node& n = node(branch);
  if (!n.bounded && n.learnt.visits < kDrawsBeforeBound) return true;
  if (!n.bounded) {
    n.bounded = true;
    n.bound = kInfinity;
    if (n.afr.depth >= AfrHierarchy::kFullyChosen) {
      const Placement middle = hierarchy_.middle(n.afr);
      const double height = hierarchy_.world().regions()[static_cast<std::size_t>(n.afr.region)].height_m;
      n.bound = objective_.upperBound({hierarchy_.world().objectPose(middle),
                                       {middle.p_WV.x(), middle.p_WV.y(), height},
                                       hierarchy_.radius_m(n.afr),
                                       AfrHierarchy::angleWidth(n.afr) / 2.0});
    }
  }
  return n.bound > threshold;
}

TreeSearch::Branch TreeSearch::selectChild(Branch branch, double threshold, std::mt19937_64& random) {
  expand(branch);
  for (;;) {
    const Node& n = node(branch);
    // UCB1's share for exploration, but for the visits of each.
    const double exploration =
        options_.exploration * std::sqrt(2.0 * std::log(std::max(1.0, n.learnt.visits)));
    Branch best = -1;
    double best_score = -kInfinity, mean = 0.0, tried = 0.0;
    for (const auto& [child, learnt] : n.children) {
      if (learnt.visits <= 0.0 || !open(child, threshold)) continue;
      const double share = learnt.rewards / learnt.visits;
      const double score = share + exploration / std::sqrt(learnt.visits);
      mean += share;
      tried += 1.0;
      if (score > best_score) {
        best_score = score;
        best = child;
      }
    }
    const bool more = !n.untried.empty();
    const double more_score = tried > 0.0 ? mean / tried + exploration / std::sqrt(tried) : kInfinity;
    if (best >= 0 && !(more && more_score > best_score)) return best;
    if (more) {
      const Branch added = addRandomChild(branch, random);
      if (open(added, threshold)) return added;
      continue;
    }
    for (const auto& [child, learnt] : n.children)  // drawn from by others that have not learnt yet
      if (open(child, threshold)) return child;
    // All children are known and closed, so the best of their bounds is this node's.
    double bound = -kInfinity;
    for (const auto& [child, learnt] : n.children) bound = std::max(bound, node(child).bound);
    node(branch).bound = bound;
    node(branch).bounded = true;
    return -1;
  }
}

bool TreeSearch::descends(Branch branch) {
  const Node& n = node(branch);
  if (n.afr.depth < AfrHierarchy::kFullyChosen) return true;
  if (n.learnt.visits <= 0.0 || hierarchy_.childCount(n.afr) == 0) return false;
  return nodes_.size() < kMostNodes || (n.expanded && n.untried.empty());
}

bool TreeSearch::draw(std::mt19937_64& random, double threshold, Placement& placement, Branch& branch) {
  while (open(0, threshold)) {
    branch = 0;
    while (branch >= 0 && descends(branch)) branch = selectChild(branch, threshold, random);
    if (branch < 0) continue;  // a node on the way has been closed
    placement = hierarchy_.sample(node(branch).afr, random);
    return true;
  }
  return false;
}

void TreeSearch::add(Branch branch, const Learnt& more) {
  for (; branch >= 0; branch = node(branch).parent) {
    Node& n = node(branch);
    n.learnt.visits += more.visits;
    n.learnt.rewards += more.rewards;
    if (n.parent >= 0) node(n.parent).children[n.place].learnt = n.learnt;
  }
}

double TreeSearch::rewardOf(const PlacementOutcome& outcome, bool leaf) const {
  if (outcome.valid()) return 1.0;
  if (options_.reward == PlacementReward::kPaper) {
    constexpr double kShare = 0.25;
    const int passed = static_cast<int>(outcome.arm_free) + static_cast<int>(outcome.object_free) +
                       static_cast<int>(outcome.stable) + static_cast<int>(outcome.better);
    return leaf ? 0.0 : kShare * passed;
  }
  if (!outcome.stable || (!outcome.object_free && !outcome.hopeless)) return 0.0;
  const int tests_missed = !outcome.better ? 3 : !outcome.hand_free ? 2 : !outcome.reachable ? 1 : 0;
  return std::ldexp(options_.stage, -tests_missed);
}

void TreeSearch::learn(Branch branch, const PlacementOutcome& outcome) {
  const bool leaf = hierarchy_.childCount(node(branch).afr) == 0;
  const double reward = rewardOf(outcome, leaf);
  add(branch, {1.0, reward});
  if (!options_.take_back || !outcome.better) return;
  PlacementOutcome passed;
  passed.stable = passed.object_free = true;
  better_.push({outcome.objective, branch, (reward - rewardOf(passed, leaf)) / faded_});
}

void TreeSearch::learnReached(const Placement& placement) {
  Branch branch = 0;
  for (;;) {
    const int number = hierarchy_.childOf(node(branch).afr, placement);
    if (number < 0 || number >= hierarchy_.childCount(node(branch).afr)) break;
    expand(branch);
    const Node& n = node(branch);
    const auto untried = std::find(n.untried.begin(), n.untried.end(), number);
    const bool added = untried != n.untried.end();
    if (added) {
      branch = addChild(branch, static_cast<std::size_t>(untried - n.untried.begin()));
      if (node(branch).afr.depth >= AfrHierarchy::kFullyChosen) break;
      continue;
    }
    const AfrNode wanted = hierarchy_.child(n.afr, number);
    const auto same = std::find_if(n.children.begin(), n.children.end(), [&](const Child& child) {
      const AfrNode& c = node(child.branch).afr;
      return c.arm == wanted.arm && c.face == wanted.face && c.region == wanted.region &&
             c.patch == wanted.patch && c.angle_low_rad == wanted.angle_low_rad;
    });
    branch = same->branch;
  }
  if (node(branch).afr.depth >= AfrHierarchy::kFullyChosen) add(branch, {1.0, 1.0});
}

void TreeSearch::thresholdRaised(double threshold) {
  for (; !better_.empty() && better_.top().objective <= threshold; better_.pop())
    add(better_.top().branch, {0.0, -better_.top().surplus * faded_});
  if (options_.discount == 1.0) return;
  for (Node& n : nodes_) {
    n.learnt.visits *= options_.discount;
    n.learnt.rewards *= options_.discount;
    if (n.parent >= 0) node(n.parent).children[n.place].learnt = n.learnt;
  }
  faded_ *= options_.discount;
  if (faded_ >= kFadedAway) return;
  better_ = {};
  faded_ = 1.0;
}

}  // namespace b4p
