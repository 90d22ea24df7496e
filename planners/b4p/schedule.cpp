// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/schedule.h"

#include <algorithm>
#include <utility>

namespace b4p {

void Schedule::add(ForestPair* forests) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Turn turn;
  turn.forests = forests;
  turn.born = all_.size() + 1;
  turn.order = orders_++;
  all_.push_back(forests);
  waiting_.push_back(turn);
}

Schedule::Waiting Schedule::soonestDue() {
  return std::min_element(waiting_.begin(), waiting_.end(), [](const Turn& a, const Turn& b) {
    return std::make_pair(a.due(), a.order) < std::make_pair(b.due(), b.order);
  });
}

/// @param rank  0 for those with the smallest gap, 1 for the next, ...
Schedule::Waiting Schedule::narrowest(std::size_t rank) {
  const auto at = waiting_.begin() + static_cast<std::ptrdiff_t>(std::min(rank, waiting_.size() - 1));
  std::nth_element(waiting_.begin(), at, waiting_.end(), [](const Turn& a, const Turn& b) {
    return std::make_pair(a.gap, a.order) < std::make_pair(b.gap, b.order);
  });
  return at;
}

Schedule::Turn Schedule::lend(Waiting turn) {
  Turn lent = *turn;
  lent.favoured = false;
  waiting_.erase(turn);
  return lent;
}

Schedule::Turn Schedule::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Waiting next = soonestDue();
  const bool some_due = next != waiting_.end() && next->due() <= all_.size();
  if (all_.empty() || (!some_due && turns_since_drawing_ >= pause_)) {
    turns_since_drawing_ = 0;
    return Turn{};
  }
  ++turns_since_drawing_;
  if (waiting_.empty()) {
    Turn turn;
    turn.shared = true;
    turn.forests = all_[shared_++ % all_.size()];
    return turn;
  }
  if (some_due) return lend(next);
  const auto halvings = static_cast<std::size_t>(__builtin_ctzll(++early_turns_));
  if (halvings == 0) return lend(next);
  Turn turn = lend(narrowest(halvings - 1));
  turn.favoured = true;
  return turn;
}

void Schedule::giveBack(const Turn& turn, Outcome outcome) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (turn.forests == nullptr) {
    constexpr std::uint64_t kLongestPause = 64;  // in turns of each pair
    pause_ = outcome == Outcome::kFruitful ? 1 : std::min(2 * pause_ + 1, kLongestPause * (all_.size() + 1));
  } else if (!turn.shared) {
    waiting_.push_back(turn.favoured ? turn : followUp(turn, outcome));
  }
}

Schedule::Turn Schedule::followUp(Turn turn, Outcome outcome) {
  constexpr std::uint64_t kLater = 32;
  turn.age = turn.age == 0 ? 1 : std::min(2 * turn.age, Turn::kOldest);
  if (outcome == Outcome::kPutOff) turn.age = std::max(turn.age, kLater);
  turn.order = orders_++;
  return turn;
}

}  // namespace b4p
