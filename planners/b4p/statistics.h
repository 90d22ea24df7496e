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
  std::atomic<std::uint64_t> grasps_taken{0};      ///< picks that a baseline has worked with
  std::atomic<std::uint64_t> placements_tried{0};  ///< how often a baseline asked for a place root (Eq. 3)
  std::atomic<std::uint64_t> pairs{0};  ///< pick and place roots of one grasp that a baseline joined
  std::atomic<std::uint64_t> restarts{0};

  void reset() {
    for (auto* count : {&iterations, &nodes, &roots, &connections_tried, &repairs_tried, &repairs_succeeded,
                        &grasps_taken, &placements_tried, &pairs, &restarts})
      count->store(0);
  }
};

inline void countOne(std::atomic<std::uint64_t>& count) { count.fetch_add(1, std::memory_order_relaxed); }

}  // namespace b4p
