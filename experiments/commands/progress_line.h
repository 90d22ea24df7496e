// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace b4p {

/// Shows one line on stderr that changes as time goes by, and wipes it at the end. Nothing is shown where
/// stderr is no terminal.
class ProgressLine {
 public:
  /// @param text  what to show now; called from a thread of its own
  explicit ProgressLine(std::function<std::string()> text);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

 private:
  void show();

  std::function<std::string()> text_;
  std::mutex mutex_;
  std::condition_variable end_;
  bool ended_ = false;
  std::thread thread_;
};

}  // namespace b4p
