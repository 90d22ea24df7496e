// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/geometric/PathGeometric.h>

namespace b4p {

/// Shortens a valid path by OMPL's PathSimplifier, whose motions pass the path's own motion validator:
/// way-points are left out, then up to `attempts` shortcuts between points anywhere on the path are tried,
/// until `done`. The first and the last state stay as they are. A path that its validator does not accept
/// afterwards is put back as it was, which happens with validators that look at other points of a shorter
/// motion. OMPL's random numbers are used. What the validator throws passes through, and the path is then as
/// it was.
void takeShortcuts(ompl::geometric::PathGeometric& path, unsigned attempts,
                   const ompl::base::PlannerTerminationCondition& done);

}  // namespace b4p
