// SPDX-License-Identifier: BSD-3-Clause
#include "planners/baselines/shared_search.h"

namespace b4p {

namespace {

class SharedWorker : public PairWorker {
 public:
  SharedWorker(SharedSearch& search, std::uint64_t seed)
      : PairWorker(search, search.parameters().range, seed), search_(search) {}

 protected:
  void advance() override {
    const std::shared_ptr<TreePair> pair = search_.pairForStep();
    if (pair == nullptr) {
      if (const auto drawn = drawPick()) search_.use(drawn);
    } else if (pair->complete()) {
      grow(*pair);
    } else {
      seek(pair);
    }
  }

 private:
  void seek(const std::shared_ptr<TreePair>& pair) {
    const RRTSharedParameters& parameters = search_.parameters();
    if (seekPlacement(*pair)) return;
    if (parameters.redraw && pair->placementsTried() >= parameters.placement_attempts) search_.giveUp(pair);
  }

  SharedSearch& search_;
};

}  // namespace

std::unique_ptr<ParallelWorker> SharedSearch::newWorker(std::uint64_t seed) {
  return std::make_unique<SharedWorker>(*this, seed);
}

void SharedSearch::resume() {
  const std::lock_guard<std::mutex> lock(mutex_);
  since_ = Clock::now();
}

void SharedSearch::pause() {
  const std::lock_guard<std::mutex> lock(mutex_);
  before_ += Clock::now() - since_;
}

bool SharedSearch::attemptIsOver() const {
  if (parameters_.restart_iterations > 0) return steps_ >= parameters_.restart_iterations;
  const std::chrono::duration<double> elapsed = before_ + (Clock::now() - since_);
  return elapsed.count() >= parameters_.restart_s;
}

// Trees with a solution stay, for those who ask for the planner's data.
std::shared_ptr<TreePair> SharedSearch::pairForStep() {
  std::shared_ptr<TreePair> old;  // outlives the lock: large trees take time to go
  const std::lock_guard<std::mutex> lock(mutex_);
  if (attemptIsOver() && !finished()) {
    if (pair_ != nullptr) countOne(statistics().restarts);
    old = pair_;
    dropPair();
    steps_ = 0;
    before_ = Clock::duration{0};
    since_ = Clock::now();
  }
  ++steps_;
  if (pair_ == nullptr) pair_ = takeGivenPick();
  return pair_;
}

void SharedSearch::dropPair() {
  if (pair_ == nullptr) return;
  forgetConnections();
  drop(pair_);
  pair_.reset();
}

void SharedSearch::use(const std::shared_ptr<TreePair>& pair) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (pair_ == nullptr)
    pair_ = pair;
  else
    drop(pair);
}

void SharedSearch::giveUp(const std::shared_ptr<TreePair>& pair) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (pair == pair_ && !pair->complete()) dropPair();
}

// A path through trees that another worker has dropped meanwhile is a path all the same.
void SharedSearch::connected(const TreePair& pair, const Junction& junction) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (&pair == pair_.get())
    publish(junction);
  else
    publish(pathThrough(junction, si()).path);
}

}  // namespace b4p
