// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "experiments/run_limits.h"
#include "experiments/runner/run_record.h"

namespace b4p {

/// A run that is still to be done.
struct RunToDo {
  std::string scene;  ///< the scene's own name
  std::string label;
  RunLimits limits;
};

/// How long runs will take (s).
struct TimeLeft {
  double about_s = 0.0;    ///< each as long as its planner's runs on the scene took so far, or its time limit
  double at_most_s = 0.0;  ///< each as long as its limits let it
};

TimeLeft timeLeft(const std::vector<RunToDo>& to_do, const std::vector<RunRecord>& done);

/// "40 s", "3 min", "2 h 5 min".
std::string durationText(double seconds);

}  // namespace b4p
