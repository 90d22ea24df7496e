// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/schedule.h"

#include <algorithm>

namespace b4p {

Schedule::Schedule() { push(Turn{}); }

void Schedule::push(Turn turn) {
  turn.order = orders_++;
  queue_.push(turn);
}

void Schedule::add(ForestPair* forests) {
  std::lock_guard<std::mutex> lock(mutex_);
  all_.push_back(forests);
  Turn turn;
  turn.forests = forests;
  turn.born = turn.due = now_;
  push(turn);
}

Schedule::Turn Schedule::take() {
  std::lock_guard<std::mutex> lock(mutex_);
  if (queue_.empty()) {
    Turn turn;
    turn.shared = true;
    if (!all_.empty()) turn.forests = all_[lent_++ % all_.size()];
    return turn;
  }
  const Turn turn = queue_.top();
  queue_.pop();
  now_ = std::max(now_, turn.due);
  return turn;
}

void Schedule::giveBack(const Turn& turn, bool fruitful) {
  if (turn.shared) return;
  std::lock_guard<std::mutex> lock(mutex_);
  Turn next = turn;
  if (turn.forests == nullptr) {
    constexpr std::uint64_t kLongestPause = 64;
    drawing_pause_ = fruitful ? 1 : std::min(kLongestPause, 2 * drawing_pause_);
    next.due = now_ + drawing_pause_;
  } else {
    next.age = turn.age == 0 ? 1 : 2 * turn.age;
    next.due = std::max(now_, turn.born + next.age);
  }
  push(next);
}

}  // namespace b4p
