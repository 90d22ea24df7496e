// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/runner/build_info.h"

#include <fstream>
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

std::map<std::string, std::string> buildInfo() {
  return {{"commit", B4P_COMMIT}, {"compiler", B4P_COMPILER},
          {"flags", B4P_FLAGS},   {"OMPL", omplVersion()},
          {"CPU", cpuModel()},    {"cores", std::to_string(std::thread::hardware_concurrency())}};
}

}  // namespace b4p
