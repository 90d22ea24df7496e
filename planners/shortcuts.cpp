// SPDX-License-Identifier: BSD-3-Clause
#include "planners/shortcuts.h"

#include <algorithm>

#include <ompl/geometric/PathSimplifier.h>

namespace b4p {

namespace og = ompl::geometric;

void takeShortcuts(og::PathGeometric& path, unsigned attempts,
                   const ompl::base::PlannerTerminationCondition& done) {
  constexpr unsigned kBetweenLooksAtTheClock = 10;
  if (attempts == 0 || done) return;
  og::PathGeometric shorter(path);
  og::PathSimplifier simplifier(path.getSpaceInformation());
  simplifier.reduceVertices(shorter, kBetweenLooksAtTheClock, kBetweenLooksAtTheClock);
  const bool metric = path.getSpaceInformation()->getStateSpace()->isMetricSpace();
  for (unsigned tried = 0; metric && tried < attempts && !done; tried += kBetweenLooksAtTheClock) {
    const unsigned steps = std::min(kBetweenLooksAtTheClock, attempts - tried);
    simplifier.shortcutPath(shorter, steps, steps);
  }
  if (shorter.length() < path.length() && shorter.check()) path = shorter;
}

}  // namespace b4p
