// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>

namespace b4p {

/// What a search has done so far. Written by workers, read from any thread.
struct Statistics {
  std::atomic<std::uint64_t> iterations{0};
  std::atomic<std::uint64_t> nodes{0};
  std::atomic<std::uint64_t> roots{0};
  std::atomic<std::uint64_t> connections_tried{0};
  std::atomic<std::uint64_t> repairs_tried{0};
  std::atomic<std::uint64_t> repairs_succeeded{0};

  void reset() {
    for (auto* count : {&iterations, &nodes, &roots, &connections_tried, &repairs_tried, &repairs_succeeded})
      count->store(0);
  }
};

inline void countOne(std::atomic<std::uint64_t>& count) { count.fetch_add(1, std::memory_order_relaxed); }

}  // namespace b4p
