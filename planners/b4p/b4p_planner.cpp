// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/b4p_planner.h"

#include "planners/b4p/search.h"
#include "planners/shortcuts.h"

namespace b4p {

B4P::B4P(const ompl::base::SpaceInformationPtr& si) : ParametrisedPlanner(si, "B4P") {
  declare("threads", &B4PParameters::threads, "1:1:64");
  declare("paper", &B4PParameters::paper, "0,1");
  declare("pick_roots", &B4PParameters::pick_roots, "1:1:1024");
  declare("place_roots", &B4PParameters::place_roots, "1:1:1024");
  declare("restart_iterations", &B4PParameters::restart_iterations, "0:1:1000000000");
  declare("relaxed", &B4PParameters::relaxed, "0,1");
  declare("repair", &B4PParameters::repair, "0,1");
  declare("slide", &B4PParameters::slide, "0,1");
  declare("range", &B4PParameters::range, "0.:0.01:10000.");
  declare("slice", &B4PParameters::slice, "1:1:100000");
  declare("retreat_steps", &B4PParameters::retreat_steps, "0:1:100");
  declare("root_attempts", &B4PParameters::root_attempts, "1:1:10000");
  declare("shortcuts", &B4PParameters::shortcuts, "0:1:100000");
  declare("repair_iterations", &B4PParameters::repair_iterations, "1:1:100000");

  declareProgress("restarts INTEGER", statistics().restarts);
  declareProgress("connections tried INTEGER", statistics().connections_tried);
  declareProgress("repairs tried INTEGER", statistics().repairs_tried);
  declareProgress("repairs succeeded INTEGER", statistics().repairs_succeeded);
}

std::unique_ptr<ParallelSearch> B4P::makeSearch(const SearchProblem& problem) {
  return std::make_unique<Search>(problem, parameters());
}

void B4P::shorten(ompl::geometric::PathGeometric& path, const ompl::base::PlannerTerminationCondition& ptc) {
  if (!parameters().paper) takeShortcuts(path, parameters().shortcuts, ptc);
}

}  // namespace b4p
