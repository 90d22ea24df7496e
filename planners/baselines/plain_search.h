// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "planners/b4p/forest.h"
#include "planners/parallel_search.h"

namespace b4p {

/// What the baselines are on a problem without pick and place: all workers grow one bidirectional RRT from
/// all starts and goals. Goals come in as in OMPL's RRTConnect: further ones while they are less than half
/// the nodes.
class PlainSearch : public ParallelSearch {
 public:
  /// @param range  longest motion added at once; 0: as far as it stays free
  PlainSearch(const SearchProblem& problem, double range);

  std::unique_ptr<ParallelWorker> newWorker(std::uint64_t seed) override;
  bool addRoot(Side side, const ompl::base::State* root, GraspId grasp) override;
  void forEachNode(const std::function<void(const Node&)>& visit) const override {
    forests_.forEachNode(visit);
  }

  ForestPair& forests() { return forests_; }

 private:
  const double range_;
  ForestPair forests_;
};

}  // namespace b4p
