// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <mutex>
#include <queue>
#include <vector>

#include "planners/b4p/forest.h"

namespace b4p {

/// Which forests grow next, so that new ones come in without limit and none is ever dropped: a pair of forests is served when it is 0, 1, 2, 4, 8, ...
/// rounds old, and each round begins with the drawing of new roots. Any thread may ask.
class Schedule {
 public:
  /// A worker's turn: forests to grow, or roots to draw when `forests` is nullptr.
  struct Turn {
    ForestPair* forests = nullptr;
    std::uint64_t born = 0;    ///< the round it came in
    std::uint64_t age = 0;     ///< at this turn, in rounds
    std::uint64_t due = 0;
    std::uint64_t order = 0;   ///< breaks ties: first come, first served
    bool shared = false;       ///< lent without being its turn, because all others are busy
  };

  Schedule();

  /// New forests: their first turn is now.
  void add(ForestPair* forests);

  /// The next turn. Forests are lent to one worker at a time as long as there is something else to do.
  Turn take();

  /// Ends a turn. For drawing: `fruitful` says whether new roots came of it; fruitless drawing becomes rarer.
  void giveBack(const Turn& turn, bool fruitful);

 private:
  struct Later {
    bool operator()(const Turn& a, const Turn& b) const {
      return a.due != b.due ? a.due > b.due : a.order > b.order;
    }
  };

  void push(Turn turn);

  std::mutex mutex_;
  std::priority_queue<Turn, std::vector<Turn>, Later> queue_;
  std::vector<ForestPair*> all_;
  std::uint64_t now_ = 0;
  std::uint64_t orders_ = 0;
  std::uint64_t drawing_pause_ = 1;
  std::size_t lent_ = 0;
};

}  // namespace b4p
