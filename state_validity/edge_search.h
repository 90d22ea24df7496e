// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "state_validity/edge_samples.h"
#include "state_validity/posed_pieces.h"

namespace b4p {

/// Checks all samples of an edge without visiting each of them for each pair of pieces.
///
/// The edge is bisected. At the middle of a stretch a pair that is farther apart than it can close on the way
/// to the stretch's ends is free on all of the stretch and is not looked at again there; a stretch without
/// pairs left is free. The answer is the one that checking every sample would give. One object per thread;
/// reuses its memory.
class EdgeSearch {
 public:
  explicit EdgeSearch(PosedPieces& pieces);

  /// True when no sample collides. Both ends are looked at first, then the middle, the quarters and so on.
  bool allFree(const EdgeSamples& samples);

  /// Smallest k <= last at which a sample collides; last + 1 if there is none. The first sample comes first.
  std::int64_t firstBlocked(const EdgeSamples& samples, std::int64_t last);

  /// Configurations looked at so far.
  std::uint64_t checked() const { return checked_; }

 private:
  // Samples first .. last are still to be checked for the pairs listed in active_[begin .. end).
  struct Stretch {
    std::int64_t first;
    std::int64_t last;
    std::size_t begin;
    std::size_t end;
    std::int64_t middle() const { return first + (last - first) / 2; }
    std::int64_t reach() const { return std::max(middle() - first, last - middle()); }
  };

  // Makes active_ the list of all pairs and works out how far they move.
  void start(const EdgeSamples& samples);

  // False if a pair of the list collides at sample k; otherwise appends to active_ those that may collide
  // within `reach` samples of it.
  bool check(const EdgeSamples& samples, std::int64_t k, std::int64_t reach, std::size_t begin,
             std::size_t end);

  void push(std::int64_t first, std::int64_t last, std::size_t begin, std::size_t end);

  PosedPieces& pieces_;
  std::vector<double> q_;
  std::vector<double> joint_motion_;   ///< of each planned joint, from one sample to the next (rad or m)
  std::vector<double> pair_motion_m_;  ///< bound of a pair's approach, from one sample to the next
  std::vector<int> active_;            ///< indices of pairs
  std::vector<Stretch> stretches_;
  std::uint64_t checked_ = 0;
};

}  // namespace b4p
