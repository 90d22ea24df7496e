// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "planners/baselines/pair_search.h"
#include "planners/baselines/parameters.h"
#include "planners/baselines/slice_race.h"

namespace b4p {

/// RRT-Restart: a race over pairs of grasp and placement, in slices that grow (SliceRace); each worker has
/// another pair.
class RestartSearch : public PairSearch {
 public:
  RestartSearch(const SearchProblem& problem, const RRTRestartParameters& parameters)
      : PairSearch(problem),
        parameters_(parameters),
        race_(parameters.slice, parameters.growth, parameters.root_attempts) {}

  std::unique_ptr<ParallelWorker> newWorker(std::uint64_t seed) override;
  const RRTRestartParameters& parameters() const { return parameters_; }
  SliceRace& race() { return race_; }

 private:
  const RRTRestartParameters parameters_;
  SliceRace race_;
};

}  // namespace b4p
