// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "planners/b4p/parameters.h"
#include "planners/parallel_planner.h"

namespace b4p {

/// B4P (Leebron, Ren, Chen, Hang, IROS 2025): parallel workers grow forests of pick and place trees under
/// many grasps at once, join trees even of different grasps, re-derive the place root for the pick's grasp
/// and repair the path.
///
/// With a PlaceGoal over a ManipulationStateSpace it solves a whole pick-and-place query: which grasp, which
/// placement, which motion. It then draws pick roots itself; start states are further ones and may be
/// missing. On any other state space with any GoalSampleableRegion it is a parallel bidirectional planner
/// with many roots. A solution is an exact path whose every motion the problem's motion validator accepted;
/// there are no approximate ones.
///
/// Parameters other than `threads` take effect at the first solve() after construction or clear(). With one
/// thread, OMPL's global seed determines the result. See ParallelPlanner for the life cycle.
class B4P : public ParametrisedPlanner<B4PParameters> {
 public:
  explicit B4P(const ompl::base::SpaceInformationPtr& si);

 protected:
  std::unique_ptr<ParallelSearch> makeSearch(const SearchProblem& problem) override;
  void shorten(ompl::geometric::PathGeometric& path,
               const ompl::base::PlannerTerminationCondition& ptc) override;
};

}  // namespace b4p
