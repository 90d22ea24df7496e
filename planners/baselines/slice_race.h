// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>

#include "planners/baselines/tree_pair.h"

namespace b4p {

/// Which pair of trees grows next, and for how long. In each round new pairs join, until there are `growth`
/// times as many, and each pair that is there has a slice `growth` times as long as its last one: however few
/// pairs lead to the goal, and however long they take, the time is a logarithm away from the best one can do
/// without knowing either (Levin's universal search). Nothing is ever dropped. Drawing of roots that brings
/// no pair ends after `root_attempts` draws per first slice of growth in the round before. Any thread may
/// ask.
class SliceRace {
 public:
  SliceRace(unsigned slice, double growth, unsigned root_attempts);

  /// A worker's turn. It has the pair for itself until it gives it back.
  struct Turn {
    std::shared_ptr<TreePair> pair;  ///< nullptr: look for a new one; set it when found, and let it grow
    std::uint64_t draws = 0;         ///< how many may be spent on looking for it; when given back: are left
    std::uint64_t iterations = 0;    ///< how many it may grow
    unsigned slices = 0;             ///< how many the pair had before
    std::uint64_t round = 0;
  };

  Turn take();
  void giveBack(const Turn& turn);

 private:
  struct Entrant {
    std::shared_ptr<TreePair> pair;
    unsigned slices;
  };

  void beginRound();
  std::uint64_t iterationsAfter(unsigned slices) const;

  const unsigned slice_;
  const double growth_;
  const unsigned root_attempts_;

  std::mutex mutex_;  // guards what follows
  std::uint64_t round_ = 0;
  std::size_t pairs_ = 0;               ///< that have had a slice
  std::size_t wanted_ = 0;              ///< new pairs in this round
  std::uint64_t draws_left_ = 0;        ///< of this round
  std::uint64_t iterations_given_ = 0;  ///< in this round
  std::deque<Entrant> due_, waiting_;   ///< in this round, for the next one
};

}  // namespace b4p
