// SPDX-License-Identifier: BSD-3-Clause
#include "planners/baselines/slice_race.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace b4p {

SliceRace::SliceRace(unsigned slice, double growth, unsigned root_attempts)
    : slice_(slice), growth_(growth), root_attempts_(root_attempts) {}

std::uint64_t SliceRace::iterationsAfter(unsigned slices) const {
  constexpr double kForever = 1e15;
  return static_cast<std::uint64_t>(std::min(slice_ * std::pow(growth_, slices), kForever));
}

void SliceRace::beginRound() {
  ++round_;
  wanted_ = std::max<std::size_t>(
      1, static_cast<std::size_t>(std::ceil((growth_ - 1.0) * static_cast<double>(pairs_))));
  draws_left_ = root_attempts_ * std::max<std::uint64_t>(1, iterations_given_ / slice_);
  iterations_given_ = 0;
  due_ = std::exchange(waiting_, {});
}

SliceRace::Turn SliceRace::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if ((wanted_ == 0 || draws_left_ == 0) && due_.empty()) beginRound();
  Turn turn;
  turn.round = round_;
  if (wanted_ > 0 && draws_left_ > 0) {
    --wanted_;
    turn.draws = std::min<std::uint64_t>(draws_left_, root_attempts_);
    draws_left_ -= turn.draws;
  } else {
    turn.pair = std::move(due_.front().pair);
    turn.slices = due_.front().slices;
    due_.pop_front();
  }
  turn.iterations = iterationsAfter(turn.slices);
  return turn;
}

void SliceRace::giveBack(const Turn& turn) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (turn.round == round_) draws_left_ += turn.draws;
  if (turn.pair == nullptr) {
    if (turn.round == round_) ++wanted_;
    return;
  }
  if (turn.slices == 0) ++pairs_;
  iterations_given_ += iterationsAfter(turn.slices);
  waiting_.push_back({turn.pair, turn.slices + 1});
}

}  // namespace b4p
