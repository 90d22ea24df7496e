// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace b4p {

/// Keeps back what a worker's step does to what workers share, so that a simulation can let the others see it
/// when the step has ended in logical time. Outside of record() nothing is kept back. For one thread; workers
/// in threads of their own share without a log.
class PublicationLog {
 public:
  using Effects = std::vector<std::function<void()>>;

  /// Takes a step and returns its effects, in the order in which they are to be done. An exception out of
  /// the step passes through, and its effects are lost.
  Effects record(const std::function<void()>& step);

  bool recording() const { return recording_; }

  /// Numbers the step that is or was last recorded.
  std::uint64_t step() const { return step_; }

  void keep(std::function<void()> effect) { effects_.push_back(std::move(effect)); }

 private:
  bool recording_ = false;
  std::uint64_t step_ = 0;
  Effects effects_;
};

/// Lets other workers see something: at once, or, while `log` records a step, later.
template <class Effect>
void share(PublicationLog* log, Effect&& effect) {
  if (log != nullptr && log->recording())
    log->keep(std::forward<Effect>(effect));
  else
    effect();
}

}  // namespace b4p
