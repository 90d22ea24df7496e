// SPDX-License-Identifier: BSD-3-Clause
#include "planners/baselines/plain_search.h"

#include "planners/b4p/growth.h"
#include "planners/b4p/motion.h"

namespace b4p {

namespace ob = ompl::base;

namespace {

class PlainWorker : public ParallelWorker {
 public:
  PlainWorker(PlainSearch& search, double range) : search_(search), motion_(search.si(), range) {}

  void step() override {
    if (search_.finished()) return;
    countOne(search_.statistics().iterations);
    ForestPair& forests = search_.forests();
    if (search_.rootCount(Side::kPlace) < forests.nodeCount() / 2) search_.plantGoal();
    const Growth growth = growAndConnect(forests, next_side_, motion_.sample(), motion_);
    next_side_ = opposite(next_side_);
    search_.statistics().nodes += growth.nodes;
    if (growth.junction && search_.rootsMatch(*growth.junction)) search_.publish(*growth.junction);
  }

 private:
  PlainSearch& search_;
  Motion motion_;
  Side next_side_ = Side::kPick;
};

}  // namespace

// In the space's own metric trees of different grasps, which cannot be joined, keep apart.
PlainSearch::PlainSearch(const SearchProblem& problem, double range)
    : ParallelSearch(problem),
      range_(range),
      forests_(
          si(), [space = si()->getStateSpace()](auto* a, auto* b) { return space->distance(a, b); },
          kNoGrasp) {}

std::unique_ptr<ParallelWorker> PlainSearch::newWorker(std::uint64_t) {
  return std::make_unique<PlainWorker>(*this, range_);
}

bool PlainSearch::addRoot(Side side, const ob::State* root, GraspId grasp) {
  if (!allFinite(*si()->getStateSpace(), root)) return false;
  if (forests_.plant(side, root, grasp, kNoPlacement) == nullptr) return false;
  countRoot(side);
  countOne(statistics().roots);
  countOne(statistics().nodes);
  return true;
}

}  // namespace b4p
