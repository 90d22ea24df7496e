// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>

#include "planners/baselines/pair_search.h"
#include "planners/baselines/parameters.h"

namespace b4p {

/// RRT-Shared: all workers take one grasp and one placement for it and grow their two trees together. When
/// the time limit of the attempt expires the trees are dropped, and another grasp is taken. Only the time
/// inside of solve() counts. Any thread may call anything.
class SharedSearch : public PairSearch {
 public:
  SharedSearch(const SearchProblem& problem, const RRTSharedParameters& parameters)
      : PairSearch(problem), parameters_(parameters) {}

  std::unique_ptr<ParallelWorker> newWorker(std::uint64_t seed) override;
  void resume() override;
  void pause() override;

  const RRTSharedParameters& parameters() const { return parameters_; }

  /// The pair to work on in a step, after a restart where it is time for one; nullptr: a pick has to be
  /// drawn.
  std::shared_ptr<TreePair> pairForStep();

  /// Makes a pair the one to work on, unless there is another by now.
  void use(const std::shared_ptr<TreePair>& pair);

  /// Drops the pair, unless others have done so: its grasp seems to have no place root.
  void giveUp(const std::shared_ptr<TreePair>& pair);

  void connected(const TreePair& pair, const Junction& junction) override;

 private:
  using Clock = std::chrono::steady_clock;

  bool attemptIsOver() const;
  void dropPair();

  const RRTSharedParameters parameters_;
  std::mutex mutex_;  // guards what follows
  std::shared_ptr<TreePair> pair_;
  std::uint64_t steps_ = 0;    ///< since the last restart
  Clock::duration before_{0};  ///< time since the last restart in earlier calls of solve()
  Clock::time_point since_;    ///< the later of last restart and begin of solve()
};

}  // namespace b4p
