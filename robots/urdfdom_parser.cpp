// SPDX-License-Identifier: BSD-3-Clause
#include "robots/urdfdom_parser.h"

#include <algorithm>
#include <exception>
#include <mutex>

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include "robots/input_error.h"

namespace b4p {
namespace {

/// While it lives, urdfdom's messages come here.
class CapturedLog : public console_bridge::OutputHandler {
 public:
  CapturedLog() : previous_(console_bridge::getOutputHandler()) { console_bridge::useOutputHandler(this); }
  ~CapturedLog() override { console_bridge::useOutputHandler(previous_); }
  CapturedLog(const CapturedLog&) = delete;
  CapturedLog& operator=(const CapturedLog&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && first_error_.empty()) first_error_ = text;
  }

  /// The first error on one line.
  std::string firstError() const {
    std::string line = first_error_;
    std::replace(line.begin(), line.end(), '\n', ' ');
    return line;
  }

 private:
  console_bridge::OutputHandler* previous_;
  std::string first_error_;
};

}  // namespace

urdf::ModelInterfaceSharedPtr parseWithUrdfdom(const std::string& file, const std::string& text) {
  static std::mutex one_at_a_time;
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  CapturedLog log;
  urdf::ModelInterfaceSharedPtr robot;
  try {
    robot = urdf::parseURDF(text);
  } catch (const std::exception& error) {
    throw InputError(file, "", std::string("urdfdom refuses it: ") + error.what());
  }
  if (!robot || !robot->getRoot()) throw InputError(file, "", "urdfdom refuses it: " + log.firstError());
  return robot;
}

}  // namespace b4p
