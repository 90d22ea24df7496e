// SPDX-License-Identifier: BSD-3-Clause
#include "planners/baselines/restart_search.h"

#include <optional>

namespace b4p {

namespace {

class RestartWorker : public PairWorker {
 public:
  RestartWorker(RestartSearch& search, std::uint64_t seed)
      : PairWorker(search, search.parameters().range, seed), search_(search) {}

  void rest() override {
    if (turn_) endTurn();
  }

 protected:
  void advance() override {
    if (!turn_) turn_ = search_.race().take();
    if (turn_->pair == nullptr)
      seekPair();
    else
      growPair();
  }

 private:
  /// One pick, unless there is one that deserves more placements, and one placement for it.
  void seekPair() {
    if (candidate_ == nullptr) candidate_ = search_.takeGivenPick();
    if (candidate_ == nullptr) candidate_ = drawPick();
    if (candidate_ != nullptr) {
      if (seekPlacement(*candidate_)) {
        turn_->pair = std::move(candidate_);
        candidate_ = nullptr;
        return;
      }
      if (candidate_->placementsTried() >= search_.parameters().placement_attempts) giveUpCandidate();
    }
    if (--turn_->draws == 0) endTurn();
  }

  void growPair() {
    grow(*turn_->pair);
    if (--turn_->iterations == 0) endTurn();
  }

  void giveUpCandidate() {
    if (candidate_ != nullptr) search_.drop(candidate_);
    candidate_ = nullptr;
  }

  void endTurn() {
    giveUpCandidate();
    search_.race().giveBack(*turn_);
    turn_.reset();
  }

  RestartSearch& search_;
  std::optional<SliceRace::Turn> turn_;
  std::shared_ptr<TreePair> candidate_;  ///< has no place root yet
};

}  // namespace

std::unique_ptr<ParallelWorker> RestartSearch::newWorker(std::uint64_t seed) {
  return std::make_unique<RestartWorker>(*this, seed);
}

}  // namespace b4p
