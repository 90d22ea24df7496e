// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/schedule.h"

#include <algorithm>

namespace b4p {

void Schedule::push(Turn turn) {
  turn.order = orders_++;
  queue_.push(turn);
}

void Schedule::add(ForestPair* forests) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Turn turn;
  turn.forests = forests;
  turn.born = all_.size() + 1;
  all_.push_back(forests);
  push(turn);
}

bool Schedule::timeToDraw() const {
  const bool some_due = !queue_.empty() && queue_.top().due() <= all_.size();
  return !some_due && turns_since_drawing_ >= pause_;
}

Schedule::Turn Schedule::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (all_.empty() || timeToDraw()) {
    turns_since_drawing_ = 0;
    return Turn{};
  }
  ++turns_since_drawing_;
  if (queue_.empty()) {
    Turn turn;
    turn.shared = true;
    turn.forests = all_[shared_++ % all_.size()];
    return turn;
  }
  const Turn turn = queue_.top();
  queue_.pop();
  return turn;
}

void Schedule::giveBack(const Turn& turn, Outcome outcome) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (turn.forests == nullptr) {
    constexpr std::uint64_t kLongestPause = 64;  // in turns of each pair
    pause_ = outcome == Outcome::kFruitful ? 1 : std::min(2 * pause_ + 1, kLongestPause * (all_.size() + 1));
  } else if (!turn.shared) {
    Turn next = turn;
    constexpr std::uint64_t kLater = 32;
    next.age = turn.age == 0 ? 1 : std::min(2 * turn.age, Turn::kOldest);
    if (outcome == Outcome::kPutOff) next.age = std::max(next.age, kLater);
    push(next);
  }
}

}  // namespace b4p
