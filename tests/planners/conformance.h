// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <ompl/base/Planner.h>

#include "planners/b4p/b4p_planner.h"

namespace b4p::test {

/// A planner as the conformance suites run it. A new planner is one more entry of plannerCases().
struct PlannerCase {
  std::string name;
  unsigned threads;
  std::function<ompl::base::PlannerPtr(const ompl::base::SpaceInformationPtr&)> make;
};

inline void PrintTo(const PlannerCase& planner, std::ostream* out) { *out << planner.name; }

inline PlannerCase b4pCase(const std::string& name, unsigned threads, bool paper) {
  return {name, threads, [threads, paper](const ompl::base::SpaceInformationPtr& si) {
            auto planner = std::make_shared<B4P>(si);
            B4PParameters parameters;
            parameters.threads = threads;
            parameters.paper = paper;
            planner->setParameters(parameters);
            return planner;
          }};
}

inline std::vector<PlannerCase> plannerCases() {
  std::vector<PlannerCase> cases;
  for (const unsigned threads : {1u, 2u, 4u, 8u}) {
    cases.push_back(b4pCase("B4P_" + std::to_string(threads), threads, false));
    cases.push_back(b4pCase("B4PPaper_" + std::to_string(threads), threads, true));
  }
  return cases;
}

inline std::string caseName(const ::testing::TestParamInfo<PlannerCase>& info) { return info.param.name; }

}  // namespace b4p::test
