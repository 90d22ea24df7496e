// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "planners/baselines/pair_search.h"
#include "planners/baselines/parameters.h"

namespace b4p {

/// RRT-Individual: each worker takes one grasp, one placement for it, and grows their two trees alone.
class IndividualSearch : public PairSearch {
 public:
  IndividualSearch(const SearchProblem& problem, const RRTIndividualParameters& parameters)
      : PairSearch(problem), parameters_(parameters) {}

  std::unique_ptr<ParallelWorker> newWorker(std::uint64_t seed) override;
  const RRTIndividualParameters& parameters() const { return parameters_; }

 private:
  const RRTIndividualParameters parameters_;
};

}  // namespace b4p
