// SPDX-License-Identifier: BSD-3-Clause
#include "planners/baselines/pair_search.h"

#include <algorithm>

namespace b4p {

namespace ob = ompl::base;

bool PairSearch::addRoot(Side side, const ob::State* root, GraspId) {
  const ob::StateSpacePtr& space = si()->getStateSpace();
  if (side != Side::kPick || !allFinite(*space, root)) return false;
  const std::lock_guard<std::mutex> lock(mutex_);
  given_.emplace_back(space, root);
  countRoot(side);
  return true;
}

std::shared_ptr<TreePair> PairSearch::takeGivenPick() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (given_.empty()) return nullptr;
  const ob::State* pick = given_.front().get();
  pairs_.push_back(std::make_shared<TreePair>(si(), pick, grasps().get(pick), statistics()));
  given_.pop_front();
  return pairs_.back();
}

std::shared_ptr<TreePair> PairSearch::addPair(const ob::State* pick, GraspId grasp) {
  auto pair = std::make_shared<TreePair>(si(), pick, grasp, statistics());
  const std::lock_guard<std::mutex> lock(mutex_);
  pairs_.push_back(pair);
  return pair;
}

// Those that are dropped are among the latest.
void PairSearch::drop(const std::shared_ptr<TreePair>& pair) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = std::find(pairs_.rbegin(), pairs_.rend(), pair);
  if (found != pairs_.rend()) pairs_.erase(std::next(found).base());
}

std::vector<std::shared_ptr<const TreePair>> PairSearch::pairs() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return {pairs_.begin(), pairs_.end()};
}

void PairSearch::forEachNode(const std::function<void(const Node&)>& visit) const {
  for (const auto& pair : pairs()) pair->forEachNode(visit);
}

PairWorker::PairWorker(PairSearch& search, double range, std::uint64_t seed)
    : search_(search), motion_(search.si(), range), drawer_(search.si(), search.region(), seed) {}

void PairWorker::step() {
  if (search_.finished()) return;
  countOne(search_.statistics().iterations);
  advance();
}

std::shared_ptr<TreePair> PairWorker::drawPick() {
  const GraspId grasp = drawer_.drawPick();
  return grasp == kNoGrasp ? nullptr : search_.addPair(drawer_.root(), grasp);
}

// A grasp without any placement asks for millions, which the region would all keep; beyond a number that
// fills it densely, those that are known are as good as new ones.
PlacementId PairWorker::drawPlacement() {
  constexpr std::size_t kMostPlacements = 100000;
  if (placements_.size() == kMostPlacements)
    return placements_[static_cast<std::size_t>(motion_.random().uniformInt(0, kMostPlacements - 1))];
  placements_.push_back(drawer_.region().samplePlacement());
  return placements_.back();
}

bool PairWorker::seekPlacement(TreePair& pair) {
  const PlacementId placement = drawPlacement();
  pair.countPlacementTried();
  countOne(search_.statistics().placements_tried);
  if (drawer_.derivePlaceRoot(placement, pair.grasp())) pair.complete(drawer_.root(), placement);
  return pair.complete();
}

void PairWorker::grow(TreePair& pair) {
  const auto junction = pair.grow(next_side_, motion_);
  next_side_ = opposite(next_side_);
  if (junction && search_.rootsMatch(*junction)) search_.connected(pair, *junction);
}

}  // namespace b4p
