// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "planners/baselines/plain_search.h"
#include "planners/parallel_planner.h"

namespace b4p {

/// What the baselines have in common as OMPL planners: on a pick-and-place problem each runs a search of its
/// own, on any other problem they are one and the same parallel bidirectional RRT.
/// @tparam Parameters  a BaselineParameters
/// @tparam PairsSearch  the search on pick-and-place problems
template <class Parameters, class PairsSearch>
class BaselinePlanner : public ParametrisedPlanner<Parameters> {
 protected:
  BaselinePlanner(const ompl::base::SpaceInformationPtr& si, const std::string& name)
      : ParametrisedPlanner<Parameters>(si, name) {
    this->declare("threads", &Parameters::threads, "1:1:64");
    this->declare("range", &Parameters::range, "0.:0.01:10000.");
    this->declare("placement_attempts", &Parameters::placement_attempts, "1:1:10000");
    this->declareProgress("grasps INTEGER", this->statistics().grasps_taken);
    this->declareProgress("placements tried INTEGER", this->statistics().placements_tried);
  }

  std::unique_ptr<ParallelSearch> makeSearch(const SearchProblem& problem) override {
    const Parameters& parameters = this->parameters();
    if (problem.region == nullptr) return std::make_unique<PlainSearch>(problem, parameters.range);
    return std::make_unique<PairsSearch>(problem, parameters);
  }
};

}  // namespace b4p
