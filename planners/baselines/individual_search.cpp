// SPDX-License-Identifier: BSD-3-Clause
#include "planners/baselines/individual_search.h"

namespace b4p {

namespace {

class IndividualWorker : public PairWorker {
 public:
  IndividualWorker(IndividualSearch& search, std::uint64_t seed)
      : PairWorker(search, search.parameters().range, seed), search_(search) {}

 protected:
  void advance() override {
    if (pair_ != nullptr && pair_->complete()) return grow(*pair_);
    if (pair_ == nullptr) pair_ = search_.takeGivenPick();
    if (pair_ == nullptr) pair_ = drawPick();
    if (pair_ != nullptr) seek();
  }

 private:
  void seek() {
    const RRTIndividualParameters& parameters = search_.parameters();
    if (seekPlacement(*pair_)) return;
    if (!parameters.redraw || pair_->placementsTried() < parameters.placement_attempts) return;
    search_.drop(pair_);
    pair_.reset();
  }

  IndividualSearch& search_;
  std::shared_ptr<TreePair> pair_;
};

}  // namespace

std::unique_ptr<ParallelWorker> IndividualSearch::newWorker(std::uint64_t seed) {
  return std::make_unique<IndividualWorker>(*this, seed);
}

}  // namespace b4p
