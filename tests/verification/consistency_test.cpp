// SPDX-License-Identifier: BSD-3-Clause
// Promises: an honest result contradicts itself nowhere; each contradiction is told by its element.
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/verification/verifier.h"
#include "verification/gantry.h"

namespace b4p {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

PlanResult solved() {
  PlanResult result = test::gantryResult();
  result.verification = {true, "", 1e-3, 1000, 0.005};
  return result;
}

PlanResult unsolved() {
  PlanResult result;
  result.status = "Timeout";
  result.time_limit_s = 10.0;
  result.planning_time_s = 10.01;
  return result;
}

TEST(Inconsistency, HonestResultsHaveNone) {
  EXPECT_EQ(inconsistency(solved()), "");
  EXPECT_EQ(inconsistency(unsolved()), "");
  PlanResult late = solved();
  late.planning_time_s = late.time_limit_s + 0.9;
  EXPECT_EQ(inconsistency(late), "");
  late = unsolved();
  late.planning_time_s = late.time_limit_s + 5.0;
  EXPECT_EQ(inconsistency(late), "") << "a planner that was slow to give up";
}

TEST(Inconsistency, SolvedStatusAndPathGoTogether) {
  PlanResult result = solved();
  result.solved = false;
  EXPECT_EQ(inconsistency(result), "solved: false contradicts the status 'Exact solution'");
  result.status = "Timeout";
  EXPECT_EQ(inconsistency(result), "solved: false contradicts the path of 4 way-points");
  result.solved = true;
  EXPECT_EQ(inconsistency(result), "solved: true contradicts the status 'Timeout'");
  result = solved();
  result.path.clear();
  EXPECT_EQ(inconsistency(result), "solved: true contradicts the path of 0 way-points");
}

TEST(Inconsistency, ThreadsAndTimesArePossible) {
  PlanResult result = solved();
  result.threads = 0;
  EXPECT_THAT(inconsistency(result), StartsWith("threads: 0"));
  for (const double limit_s : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    result = solved();
    result.time_limit_s = limit_s;
    EXPECT_THAT(inconsistency(result), StartsWith("time_limit_s: "));
  }
  for (const double time_s : {-1e-9, 11.5, std::numeric_limits<double>::quiet_NaN()}) {
    result = solved();
    result.planning_time_s = time_s;
    EXPECT_THAT(inconsistency(result), StartsWith("planning_time_s: "));
  }
  result = unsolved();
  result.planning_time_s = -1.0;
  EXPECT_THAT(inconsistency(result), StartsWith("planning_time_s: -1"));
}

TEST(Inconsistency, ThePathHasPassedTheStoredVerification) {
  PlanResult result = solved();
  result.verification.passed = false;
  EXPECT_THAT(inconsistency(result), HasSubstr("the file's own verification says that the path failed"));
  result.verification.failure = "edge 1:\ntouches";
  EXPECT_THAT(inconsistency(result), HasSubstr("failed: 'edge 1: touches'")) << "one line";
  result.verification.passed = true;
  EXPECT_THAT(inconsistency(result), StartsWith("verification.failure: "));
  result = unsolved();
  result.verification.passed = true;
  EXPECT_THAT(inconsistency(result), StartsWith("verification.passed: true"));
}

}  // namespace
}  // namespace b4p
