// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

namespace b4p {

/// Which of two limits ends a run.
enum class StopRule {
  kEither,  ///< the one that is reached first
  kBoth,    ///< the one that is reached last, so that one run tells what is solved under each of them
};

/// What times of a run are read from.
enum class RunClock {
  kElapsed,
  kProcessor,  ///< processor time of the process, all threads together: hardly disturbed by other programs
};

/// How long a run may go on.
struct RunLimits {
  double time_s = 0.0;                       ///< > 0
  std::optional<std::uint64_t> checks = {};  ///< configurations checked for the planner; none: no limit
  StopRule stop = StopRule::kEither;         ///< matters where both are limited
  RunClock clock = RunClock::kElapsed;

  /// The time (s) after which a run ends whatever it has done. Under kBoth a planner that hardly checks
  /// anything would never use up its checks; it gets a few times its time.
  double longest_s() const;
};

/// Tells a run that its limits are reached. Any number of threads may ask, in their inner loops.
class LimitWatch {
 public:
  using Clock = std::chrono::steady_clock;

  /// Time counts from here on.
  /// @param checks  configurations checked so far; it is called every few milliseconds, since threads that
  ///   read a counter slow down those that count
  LimitWatch(const RunLimits& limits, std::function<std::uint64_t()> checks);

  bool reached();
  /// By the limits' clock.
  double elapsed_s() const { return std::chrono::duration<double>(now() - start_).count(); }

 private:
  Clock::time_point now() const;
  bool checksUsedUp(Clock::time_point now);

  RunLimits limits_;
  std::function<std::uint64_t()> checks_;
  Clock::time_point start_, end_, longest_;
  std::atomic<Clock::rep> next_look_{0};
  std::atomic<bool> checks_used_up_{false};
};

}  // namespace b4p
