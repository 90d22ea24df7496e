// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/virtual_time.h"

#include <algorithm>
#include <utility>

#include "planners/processor_time.h"

namespace b4p {

double threadCost(const std::function<void()>& work) {
  const double begin_s = threadTime_s();
  work();
  return threadTime_s() - begin_s;
}

VirtualTime::VirtualTime(std::size_t workers, PublicationLog& log, CostClock cost)
    : log_(log), cost_(std::move(cost)), workers_(workers) {}

// Of several at one time, those whose step ends come first: steps that begin then see its effects.
VirtualTime::Worker* VirtualTime::earliest() {
  Worker* first = nullptr;
  for (Worker& worker : workers_) {
    if (worker.rests) continue;
    if (first == nullptr || worker.clock_s < first->clock_s ||
        (worker.clock_s == first->clock_s && worker.under_way && !first->under_way))
      first = &worker;
  }
  return first;
}

VirtualTime::Report VirtualTime::run(const std::function<void(std::size_t)>& step,
                                     const std::function<bool()>& finished, const std::function<bool()>& stop,
                                     double limit_s) {
  Report report;
  while (Worker* worker = earliest()) {
    if (worker->under_way) {
      const double end_s = worker->clock_s;
      worker->under_way = false;
      ++steps_;
      worker->clock_s += cost_([&] {
        for (const auto& effect : worker->effects) effect();
      });
      worker->effects.clear();
      if (!report.finished && finished()) {
        report = reportAt(end_s);
        report.finished = true;
      }
    } else if (report.finished || worker->clock_s >= limit_s || stop()) {
      worker->rests = true;
    } else {
      const auto number = static_cast<std::size_t>(worker - workers_.data());
      worker->begin_s = worker->clock_s;
      worker->clock_s += cost_([&] { worker->effects = log_.record([&] { step(number); }); });
      worker->under_way = true;
    }
  }
  if (report.finished) return report;
  const auto last = std::max_element(workers_.begin(), workers_.end(),
                                     [](const Worker& a, const Worker& b) { return a.clock_s < b.clock_s; });
  return reportAt(last->clock_s);
}

// A worker is never idle: up to a time it has worked that long, the step it has not ended by then left aside.
VirtualTime::Report VirtualTime::reportAt(double time_s) const {
  Report report;
  report.time_s = time_s;
  report.steps = steps_;
  for (const Worker& worker : workers_)
    report.work_s += worker.under_way ? worker.begin_s : std::min(worker.clock_s, time_s);
  return report;
}

}  // namespace b4p
