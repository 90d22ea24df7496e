// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <utility>
#include <vector>

#include "planners/b4p/forest.h"
#include "planners/reach/reach_targets.h"

namespace b4p {

/// For each grasp the few tree nodes whose TCP is nearest to it among those from which steering to it has not
/// been tried. Kept up to date node by node. One thread.
class ApproachTable {
 public:
  /// @param targets  has to outlive the table
  explicit ApproachTable(const ReachTargets& targets) : targets_(targets), nearest_(targets.size()) {}

  /// Takes note of a node whose TCP is at X_WT.
  /// @param except  the grasp towards which the node was steered, for which it is no news; or kNoGrasp
  /// @return the grasp within whose tolerance it is, or kNoGrasp; it then starts no way to any grasp.
  GraspId offer(const Node* node, const Eigen::Isometry3d& X_WT, GraspId except = kNoGrasp);

  /// Like offer(), to one grasp alone.
  void offerTo(GraspId grasp, const Node* node, const Eigen::Isometry3d& X_WT);

  /// Draws a grasp that has a node: uniformly, or with probability ~ 1 / distance of its nearest node.
  /// kNoGrasp when none has.
  GraspId draw(std::mt19937_64& random, bool weighted) const;

  /// The nearest node of a grasp that has one; it does not come again for this grasp.
  const Node* take(GraspId grasp);

 private:
  using Entry = std::pair<double, const Node*>;  ///< distance from the grasp, node
  void insert(GraspId grasp, double distance, const Node* node);

  const ReachTargets& targets_;
  std::vector<std::vector<Entry>> nearest_;  ///< per grasp, nearest last
  std::vector<double> distances_;            ///< of the node on offer
};

}  // namespace b4p
