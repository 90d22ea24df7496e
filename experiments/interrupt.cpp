// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/interrupt.h"

#include <atomic>
#include <csignal>

namespace b4p {
namespace {

std::atomic<bool> g_interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

void onSignal(int signal) {
  g_interrupted = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catchInterrupts() {
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
}

bool interrupted() { return g_interrupted; }

}  // namespace b4p
