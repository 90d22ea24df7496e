// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <ompl/base/Planner.h>

#include "planners/b4p/b4p_planner.h"
#include "planners/baselines/rrt_individual.h"
#include "planners/baselines/rrt_restart.h"
#include "planners/baselines/rrt_shared.h"
#include "planners/placement/redirectable_rrt_connect.h"

namespace b4p::test {

/// A planner as the conformance suites run it. A new planner is one more entry of plannerCases().
struct PlannerCase {
  std::string name;
  unsigned threads;
  std::function<ompl::base::PlannerPtr(const ompl::base::SpaceInformationPtr&)> make;
  bool settles = false;  ///< on a few grasps, which may be the wrong ones
};

inline void PrintTo(const PlannerCase& planner, std::ostream* out) { *out << planner.name; }

template <class Planner, class Parameters>
PlannerCase plannerCase(const std::string& name, Parameters parameters, unsigned threads,
                        bool settles = false) {
  parameters.threads = threads;
  const auto make = [parameters](const ompl::base::SpaceInformationPtr& si) {
    auto planner = std::make_shared<Planner>(si);
    planner->setParameters(parameters);
    return planner;
  };
  return {name + "_" + std::to_string(threads), threads, make, settles};
}

inline PlannerCase b4pCase(unsigned threads, bool paper) {
  B4PParameters parameters;
  parameters.paper = paper;
  return plannerCase<B4P>(paper ? "B4PPaper" : "B4P", parameters, threads, paper);
}

inline PlannerCase sharedCase(unsigned threads) {
  RRTSharedParameters parameters;
  parameters.restart_iterations = 5000;
  return plannerCase<RRTShared>("RRTShared", parameters, threads);
}

inline PlannerCase redirectableCase() {
  const auto make = [](const ompl::base::SpaceInformationPtr& si) {
    return std::make_shared<RedirectableRRTConnect>(si);
  };
  return {"RedirectableRRTConnect", 1, make};
}

inline std::vector<PlannerCase> plannerCases() {
  std::vector<PlannerCase> cases;
  for (const unsigned threads : {1u, 2u, 4u, 8u}) {
    cases.push_back(b4pCase(threads, false));
    cases.push_back(b4pCase(threads, true));
  }
  for (const unsigned threads : {1u, 4u}) {
    cases.push_back(plannerCase<RRTIndividual>("RRTIndividual", RRTIndividualParameters{}, threads, true));
    cases.push_back(sharedCase(threads));
    cases.push_back(plannerCase<RRTRestart>("RRTRestart", RRTRestartParameters{}, threads));
  }
  cases.push_back(redirectableCase());
  return cases;
}

inline std::string caseName(const ::testing::TestParamInfo<PlannerCase>& info) { return info.param.name; }

}  // namespace b4p::test
