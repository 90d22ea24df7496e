// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/speedup/speed_run.h"

#include <memory>
#include <stdexcept>

#include "experiments/verification/verifier.h"
#include "planners/b4p/virtual_time_b4p.h"
#include "planners/processor_time.h"

namespace b4p {

namespace ob = ompl::base;

namespace {

/// A simulation ends by its logical clock; N workers take N times as long, or longer, on this machine's.
constexpr double kNoLimit_s = 1e9;

QuerySettings settingsFor(const SpeedStudy& study, const SpeedCase& which) {
  QuerySettings settings;
  settings.planner = study.planner;
  settings.checker = CheckerKind::kFcl;  // that of the study which is reproduced costs as much
  settings.parameters = study.parameters;
  settings.seed = which.seed;
  settings.threads = which.workers;
  settings.time_limit_s = which.real_threads ? study.time_limit_s : kNoLimit_s;
  return settings;
}

std::uint64_t iterationsOf(const ob::Planner& planner) {
  const auto& properties = planner.getPlannerProgressProperties();
  const auto iterations = properties.find("iterations INTEGER");
  return iterations == properties.end() ? 0 : std::stoull(iterations->second());
}

}  // namespace

PlannerCatalogue virtualTimeCatalogue(double limit_s,
                                      const std::function<void(const VirtualTimeB4P&)>& made) {
  const auto kind = [limit_s, made](bool paper) {
    return [limit_s, made, paper](const ob::SpaceInformationPtr& si) {
      auto planner = std::make_shared<VirtualTimeB4P>(si, limit_s);
      planner->params().setParam("paper", paper ? "1" : "0");
      made(*planner);
      return planner;
    };
  };
  PlannerCatalogue catalogue;
  catalogue.add({"b4p", "B4P in logical time", 0, kind(false)});
  catalogue.add({"b4p-paper", "B4P as printed, in logical time", 0, kind(true)});
  return catalogue;
}

SpeedRun makeSpeedRun(const Scene& scene, const SpeedStudy& study, const SpeedCase& which,
                      const std::string& where, const PlannerWatch& watch) {
  const VirtualTimeB4P* simulated = nullptr;
  const PlannerCatalogue catalogue =
      virtualTimeCatalogue(study.time_limit_s, [&](const VirtualTimeB4P& made) { simulated = &made; });
  catalogue.find(study.planner, where);  // other planners have no workers, in threads either
  Query query(scene, study.scene, which.real_threads ? PlannerCatalogue::standard() : catalogue,
              settingsFor(study, which), where);
  watch(query.planner().get());
  const double begin_s = processTime_s();
  query.solve();
  const double work_s = processTime_s() - begin_s;
  watch(nullptr);
  const PlanResult result = query.result();
  if (crashed(result)) throw std::runtime_error(study.planner + " crashed: " + query.planner()->crash());

  SpeedRun run;
  run.which = which;
  run.solved = result.solved;
  run.verified = result.solved && verify(scene, result).passed;
  if (which.real_threads) {
    run.time_s = result.planning_time_s;
    run.work_s = work_s;
    run.steps = iterationsOf(*query.planner());
  } else {
    const VirtualTime::Report& report = simulated->report();
    run.time_s = report.time_s;
    run.work_s = report.work_s;
    run.steps = report.steps;
  }
  return run;
}

}  // namespace b4p
