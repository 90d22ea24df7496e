// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <mutex>

namespace b4p {

/// A sum to which many threads contribute without disturbing each other.
class ConfigurationCounts {
 public:
  /// One contributor's own count, on a cache line of its own. Lives as long as the sum.
  struct alignas(64) Count {
    std::atomic<std::uint64_t> value{0};
  };

  Count& add() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return counts_.emplace_back();
  }

  std::uint64_t total() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::uint64_t sum = 0;
    for (const Count& count : counts_) sum += count.value.load(std::memory_order_relaxed);
    return sum;
  }

 private:
  mutable std::mutex mutex_;
  std::deque<Count> counts_;
};

}  // namespace b4p
