// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/run_limits.h"

#include <utility>

#include "planners/processor_time.h"

namespace b4p {
namespace {

constexpr double kLongestOverTime = 5.0;  // under StopRule::kBoth
constexpr std::chrono::milliseconds kBetweenLooks{2};

LimitWatch::Clock::duration seconds(double value) {
  return std::chrono::duration_cast<LimitWatch::Clock::duration>(std::chrono::duration<double>(value));
}

}  // namespace

double RunLimits::longest_s() const {
  return checks && stop == StopRule::kBoth ? kLongestOverTime * time_s : time_s;
}

LimitWatch::LimitWatch(const RunLimits& limits, std::function<std::uint64_t()> checks)
    : limits_(limits),
      checks_(std::move(checks)),
      start_(now()),
      end_(start_ + seconds(limits.time_s)),
      longest_(start_ + seconds(limits.longest_s())) {}

bool LimitWatch::reached() {
  const auto time = now();
  const bool time_used_up = time >= end_;
  if (!limits_.checks || !checks_) return time_used_up;
  if (limits_.stop == StopRule::kEither) return time_used_up || checksUsedUp(time);
  return time_used_up && (time >= longest_ || checksUsedUp(time));
}

LimitWatch::Clock::time_point LimitWatch::now() const {
  return limits_.clock == RunClock::kProcessor ? Clock::time_point(seconds(processTime_s())) : Clock::now();
}

bool LimitWatch::checksUsedUp(Clock::time_point now) {
  const auto ticks = now.time_since_epoch().count();
  if (ticks >= next_look_.load(std::memory_order_relaxed)) {
    next_look_.store(ticks + Clock::duration(kBetweenLooks).count(), std::memory_order_relaxed);
    if (checks_() >= *limits_.checks) checks_used_up_.store(true, std::memory_order_relaxed);
  }
  return checks_used_up_.load(std::memory_order_relaxed);
}

}  // namespace b4p
