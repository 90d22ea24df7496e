// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "experiments/planners.h"
#include "experiments/query.h"
#include "experiments/scene.h"

namespace b4p {

class VirtualTimeB4P;

/// What the runs of one study of speed-up have in common.
struct SpeedStudy {
  std::string scene;  ///< as loadScene() takes it
  std::string planner = "b4p";
  PlannerParameters parameters;  ///< those that were set
  double time_limit_s = 0.0;     ///< of each run, on its own clock; > 0
};

/// Which run of a study: how many workers, in logical time or in threads of their own.
struct SpeedCase {
  bool real_threads = false;
  unsigned workers = 1;
  std::uint64_t seed = 1;

  bool operator==(const SpeedCase& other) const {
    return real_threads == other.real_threads && workers == other.workers && seed == other.seed;
  }
};

/// How a run went.
struct SpeedRun {
  SpeedCase which;
  bool solved = false;
  bool verified = false;  ///< false when not solved
  double time_s = 0.0;    ///< logical time to the solution, elapsed time with threads; else when it ended
  double work_s = 0.0;  ///< processor time of all steps that had ended by then; with threads, of the process
  std::uint64_t steps = 0;  ///< how many those are; with threads, that had begun
};

/// Called with the planner before it starts to work, and with nullptr once it has ended.
using PlannerWatch = std::function<void(const ompl::base::Planner*)>;

/// b4p and b4p-paper, whose workers run in logical time.
/// @param made  called with each planner that is made
PlannerCatalogue virtualTimeCatalogue(double limit_s, const std::function<void(const VirtualTimeB4P&)>& made);

/// Makes one run and verifies its path. For real threads the machine must have that many idle cores if the
/// time is to mean anything. One at a time in a process (Query).
/// @param where  named in errors about planner and parameters
/// @throws InputError; std::runtime_error when the planner crashes
SpeedRun makeSpeedRun(const Scene& scene, const SpeedStudy& study, const SpeedCase& which,
                      const std::string& where, const PlannerWatch& watch);

}  // namespace b4p
