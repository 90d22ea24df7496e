// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/commands/progress_line.h"

#include <unistd.h>

#include <chrono>
#include <iostream>
#include <utility>

namespace b4p {

ProgressLine::ProgressLine(std::function<std::string()> text) : text_(std::move(text)) {
  if (::isatty(STDERR_FILENO) != 0) thread_ = std::thread([this] { show(); });
}

ProgressLine::~ProgressLine() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ended_ = true;
  }
  end_.notify_all();
  thread_.join();
}

void ProgressLine::show() {
  constexpr std::chrono::milliseconds kPeriod{200};
  constexpr const char* kWipe = "\r\x1b[K";
  std::unique_lock<std::mutex> lock(mutex_);
  while (!end_.wait_for(lock, kPeriod, [this] { return ended_; }))
    std::cerr << kWipe << text_() << std::flush;
  std::cerr << kWipe << std::flush;
}

}  // namespace b4p
