// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "experiments/result.h"

namespace b4p {

/// One run of a benchmark, as far as tables need it.
struct RunRecord {
  std::string scene;  ///< the scene's own name
  std::string label;
  int run = 0;        ///< counted from 1
  PlanResult result;  ///< verified where solved
  bool crashed = false;
  std::string crash;  ///< why

  bool verified() const { return result.solved && result.verification.passed; }
};

}  // namespace b4p
