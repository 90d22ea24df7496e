// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace b4p {

/// Calls job(0), ..., job(size - 1), each in a thread of its own, the calling thread being one of them, and
/// returns when all have ended. A job ends soon after `stop` is set, which happens when another has thrown;
/// the first exception is then thrown here.
void runCrew(std::size_t size,
             const std::function<void(std::size_t number, const std::atomic<bool>& stop)>& job);

}  // namespace b4p
