// SPDX-License-Identifier: BSD-3-Clause
#include "planners/placement/redirectable_data.h"

#include <set>

#include "planners/guarded_planner.h"

namespace b4p {

namespace ob = ompl::base;

void addTo(ob::PlannerData& data, const RedirectableSearch& search) {
  std::set<const ob::State*> goals;
  for (const GoalId id : search.goals()) goals.insert(search.goalState(id));
  search.forEachNode([&](const Node& node) {
    const bool root_of_goals = node.parent == nullptr && node.tree->side == Side::kPlace;
    if (root_of_goals && goals.count(node.state) == 0)
      data.addVertex(ob::PlannerDataVertex(node.state, kPlaceTag));
    else
      addTo(data, node);
  });
}

}  // namespace b4p
