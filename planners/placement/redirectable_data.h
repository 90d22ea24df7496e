// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/PlannerData.h>

#include "planners/placement/redirectable_search.h"

namespace b4p {

/// Adds all trees: vertices are tagged 1 (forward) or 2 (backward), edges point from start to goal, goals are
/// the open ones.
void addTo(ompl::base::PlannerData& data, const RedirectableSearch& search);

}  // namespace b4p
