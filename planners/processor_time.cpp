// SPDX-License-Identifier: BSD-3-Clause
#include "planners/processor_time.h"

#include <time.h>

#include <chrono>

namespace b4p {
namespace {

double read_s(clockid_t clock) {
  constexpr double kNanosecond_s = 1e-9;
  timespec time{};
  if (::clock_gettime(clock, &time) == 0)
    return static_cast<double>(time.tv_sec) + kNanosecond_s * static_cast<double>(time.tv_nsec);
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

double threadTime_s() { return read_s(CLOCK_THREAD_CPUTIME_ID); }
double processTime_s() { return read_s(CLOCK_PROCESS_CPUTIME_ID); }

}  // namespace b4p
