// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/runner/build_info.h"

#include <fstream>
#include <sstream>
#include <thread>

#include <ompl/config.h>

#include "b4p_commit.h"

namespace b4p {
namespace {

std::string cpuModel() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const auto colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

}  // namespace

std::string omplVersion() {
  return std::to_string(OMPL_MAJOR_VERSION) + "." + std::to_string(OMPL_MINOR_VERSION) + "." +
         std::to_string(OMPL_PATCH_VERSION);
}

std::string buildInfo() {
  std::ostringstream text;
  text << "commit: " << B4P_COMMIT << "\n"
       << "compiler: " << B4P_COMPILER << "\n"
       << "flags: " << B4P_FLAGS << "\n"
       << "OMPL: " << omplVersion() << "\n"
       << "CPU: " << cpuModel() << "\n"
       << "cores: " << std::thread::hardware_concurrency() << "\n";
  return text.str();
}

}  // namespace b4p
