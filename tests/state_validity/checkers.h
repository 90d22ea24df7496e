// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "state_validity/collision_checker.h"

namespace b4p::testing {

/// A collision checker under test. The conformance suite runs over every entry of allCheckers(): a new
/// checker is one more line there.
struct CheckerMaker {
  std::string name;
  std::function<std::shared_ptr<const CollisionChecker>(CollisionProblem)> make;
};

inline std::ostream& operator<<(std::ostream& out, const CheckerMaker& maker) { return out << maker.name; }

inline auto allCheckers() {
  return ::testing::Values(CheckerMaker{"Fcl", makeFclChecker}, CheckerMaker{"Vector", makeVectorChecker});
}

inline std::string checkerName(const ::testing::TestParamInfo<CheckerMaker>& info) { return info.param.name; }

/// Base of all suites of the conformance tests.
class CheckerConformance : public ::testing::TestWithParam<CheckerMaker> {
 protected:
  std::shared_ptr<const CollisionChecker> make(CollisionProblem problem) const {
    return GetParam().make(std::move(problem));
  }
  std::unique_ptr<CollisionContext> makeContext(CollisionProblem problem) const {
    return make(std::move(problem))->makeContext();
  }
};

}  // namespace b4p::testing
