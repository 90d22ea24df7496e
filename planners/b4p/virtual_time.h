// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "planners/b4p/publication_log.h"

namespace b4p {

/// Does some work and says what it cost (s, >= 0).
using CostClock = std::function<double(const std::function<void()>& work)>;

/// Costs in processor time of the calling thread (POSIX CLOCK_THREAD_CPUTIME_ID), which other programs on the
/// machine do not take part in; in elapsed time where the system cannot tell.
double threadCost(const std::function<void()>& work);

/// Runs workers side by side in logical time, on one thread. Each has a clock of its own. The worker whose
/// clock is earliest takes its next step, for real, and its clock moves on by what that cost. When the step
/// ends on that clock its effects are shared: steps that begin then or later see them, those that began
/// before do not. Sharing costs the worker time as well (inserting into an index does), after the step's end.
class VirtualTime {
 public:
  struct Report {
    bool finished = false;  ///< the search finished
    double time_s = 0.0;    ///< logical: the end of the step that finished the search, else of the last one
    double work_s = 0.0;  ///< cost of all steps that had ended by then; time_s <= work_s <= workers x time_s
    std::uint64_t steps = 0;  ///< how many those are
  };

  /// @param workers  >= 1; they all begin at 0
  VirtualTime(std::size_t workers, PublicationLog& log, CostClock cost);

  /// Until the search has finished, all clocks have reached `limit_s`, or `stop` says so; steps that have
  /// begun by then are ended. To be called once. What `step` throws passes through.
  /// @param step      lets the worker of this number take one step, which shares through the log
  /// @param finished  whether an effect shared so far has finished the search
  Report run(const std::function<void(std::size_t number)>& step, const std::function<bool()>& finished,
             const std::function<bool()>& stop, double limit_s);

 private:
  struct Worker {
    double clock_s = 0.0;
    double begin_s = 0.0;             ///< of its last step
    PublicationLog::Effects effects;  ///< of its last step, while they are not shared yet
    bool under_way = false;           ///< whether its last step has not ended yet
    bool rests = false;
  };

  Worker* earliest();
  Report reportAt(double time_s) const;

  PublicationLog& log_;
  CostClock cost_;
  std::vector<Worker> workers_;
  std::uint64_t steps_ = 0;
};

}  // namespace b4p
