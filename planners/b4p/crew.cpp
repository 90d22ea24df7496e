// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/crew.h"

#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace b4p {

void runCrew(std::size_t size,
             const std::function<void(std::size_t number, const std::atomic<bool>& stop)>& job) {
  std::atomic<bool> stop{false};
  std::mutex mutex;
  std::exception_ptr first;
  const auto fail = [&] {
    const std::lock_guard<std::mutex> lock(mutex);
    if (!first) first = std::current_exception();
    stop = true;
  };
  const auto guarded = [&](std::size_t number) {
    try {
      job(number, stop);
    } catch (...) {
      fail();
    }
  };
  std::vector<std::thread> threads;
  try {
    threads.reserve(size);
    for (std::size_t number = 1; number < size; ++number) threads.emplace_back(guarded, number);
  } catch (...) {
    fail();  // no further thread to be had
  }
  if (!stop) guarded(0);
  for (std::thread& thread : threads) thread.join();
  if (first) std::rethrow_exception(first);
}

}  // namespace b4p
