// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <mutex>
#include <vector>

#include "planners/b4p/forest.h"

namespace b4p {

/// Which forests grow next, so that new ones come in without limit and none is ever dropped. The age of a
/// pair of forests is the number of pairs that have come in after it; it is served at ages 0, 1, 2, 4, 8,
/// ..., or from age 32 on when its first turn shows little promise. When none is due, roots are drawn;
/// drawing that brings nothing new becomes rarer but never stops. Meanwhile turns are early: of these every
/// second is of the forests that are due soonest, every fourth of those whose two sides have come nearest to
/// each other, every eighth of the second nearest, and so on. Any thread may ask.
class Schedule {
 public:
  /// A worker's turn: forests to grow, or roots to draw when `forests` is nullptr.
  struct Turn {
    static constexpr std::uint64_t kOldest = std::uint64_t{1} << 32;
    ForestPair* forests = nullptr;
    std::uint64_t born = 0;   ///< how many pairs had come in before it
    std::uint64_t age = 0;    ///< at this turn
    std::uint64_t order = 0;  ///< breaks ties: first come, first served
    bool shared = false;      ///< lent without being its turn, because all others are busy
    bool favoured = false;    ///< lent without being its turn, because its sides are near each other
    double gap = std::numeric_limits<double>::infinity();  ///< least distance seen between the sides
    /// The very old are all due alike, so that they are served in turn.
    std::uint64_t due() const { return age < kOldest ? born + age : kOldest; }
  };

  /// New forests: their first turn is now.
  void add(ForestPair* forests);

  /// The next turn. Forests are lent to one worker at a time as long as there is something else to do.
  Turn take();

  /// What a turn says about those to come.
  enum class Outcome {
    kFruitless,  ///< of drawing: nothing new came of it
    kFruitful,   ///< of drawing: something new did
    kGrown,      ///< forests have grown
    kPutOff      ///< forests have not grown: others are more promising
  };

  void giveBack(const Turn& turn, Outcome outcome);

 private:
  using Waiting = std::vector<Turn>::iterator;

  Waiting soonestDue();
  Waiting narrowest(std::size_t rank);
  Turn lend(Waiting turn);
  Turn followUp(Turn turn, Outcome outcome);

  std::mutex mutex_;
  std::vector<Turn> waiting_;
  std::vector<ForestPair*> all_;
  std::uint64_t orders_ = 0;
  std::uint64_t turns_since_drawing_ = 0;
  std::uint64_t early_turns_ = 0;
  std::uint64_t pause_ = 0;  ///< turns between two drawings while no forests are due
  std::size_t shared_ = 0;
};

}  // namespace b4p
