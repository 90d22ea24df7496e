// SPDX-License-Identifier: BSD-3-Clause
// Scenes with a list of grasps of one's own: no other is used, the verifier compares, bad rows are refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "experiments/fixtures.h"
#include "experiments/result.h"

namespace b4p::test {
namespace {

using ::testing::HasSubstr;

// The gripper in front of the square's lower edge, and of its upper one; approach z, closing axis y.
constexpr const char* kBelow = "0,-1,0,0, 0,0,1,-0.13, -1,0,0,0, 0,0,0,1, 0";
constexpr const char* kAbove = "0,1,0,0, 0,0,-1,0.13, -1,0,0,0, 0,0,0,1, 0";

class ListedGrasps : public ::testing::Test {
 protected:
  ListedGrasps() { list(std::string(kBelow) + "\n" + kAbove + "\n"); }

  void list(const std::string& rows) { writeText(copy_.folder() / "square.grasps.csv", rows); }
  CommandRun plan() { return runB4p("plan " + copy_.scene() + " --out " + result_); }

  void expectRefused(const std::string& rows, const std::string& problem) {
    list(rows);
    const CommandRun run = plan();
    EXPECT_EQ(run.exit_code, 2) << run.out;
    EXPECT_EQ(run.errorLines(), 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr("square.grasps.csv"));
    EXPECT_THAT(run.err, HasSubstr(problem));
  }

  const std::vector<SceneCopy::Change> listed_{
      {"polygon_edges: {polygon_m: [[-0.1, -0.1], [0.1, -0.1], [0.1, 0.1], [-0.1, 0.1]], clearance_m: 0.03}",
       "file: square.grasps.csv"}};
  SceneCopy copy_{listed_};
  std::string result_ = copy_.folder() / "r.json";
};

TEST_F(ListedGrasps, AreUsedAndVerifiedByTheirRow) {
  ASSERT_EQ(plan().exit_code, 0);
  PlanResult result = readResult(result_);
  ASSERT_GE(result.grasp_id, 0);
  ASSERT_LE(result.grasp_id, 1);
  EXPECT_NEAR(result.grasp.X_OT.translation().y(), result.grasp_id == 0 ? -0.13 : 0.13, 1e-12);
  EXPECT_EQ(runB4p("verify " + result_).exit_code, 0);

  result.grasp_id = 1 - result.grasp_id;
  writeResult(result_, result);
  const CommandRun run = runB4p("verify " + result_);
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.out, HasSubstr("from the one of row"));

  result.grasp_id = 2;
  writeResult(result_, result);
  EXPECT_THAT(runB4p("verify " + result_).out, HasSubstr("row 3 is none of the 2 listed"));
}

TEST_F(ListedGrasps, NumbersFollowTheRows) {
  list(kAbove);
  ASSERT_EQ(plan().exit_code, 0);
  EXPECT_EQ(readResult(result_).grasp_id, 0);
  EXPECT_NEAR(readResult(result_).grasp.X_OT.translation().y(), 0.13, 1e-12);
}

TEST_F(ListedGrasps, BadRowsAreRefused) {
  expectRefused("", "holds no grasp");
  expectRefused(std::string(kBelow) + "\n0,-1,0,0, 0,0,1,-0.13, -1,0,0,0, 0,0,0,1\n",
                "row 2: has 16 columns instead of 17");
  expectRefused("0,-1,0,0, 0,0,1,-0.13, -1,0,0,0, 0,0,0,1, 0.01", "opening outside 0 to 0 m (0.01)");
  expectRefused("0,-1,0,0, 0,0,1,-0.13, -1,0,0,0, 0,0,0,1, -0.01", "opening outside");
  expectRefused("0,-1,0,0, 0,0,1,-0.13, -1,0,0,0, 0,0,0,1, wide", "column 17 is not a number (wide)");
  expectRefused("0,-1,0,0, 0,0,2,-0.13, -1,0,0,0, 0,0,0,1, 0", "not orthonormal");
}

TEST_F(ListedGrasps, ABenchmarkDoesNotGoOnWithAnotherList) {
  const std::string experiment = copy_.folder() / "quick.yaml", out = copy_.folder() / "out";
  writeText(experiment,
            "schema: 1\nname: quick\nruns: 1\ntime_limit_s: 5\nthreads: 1\nseed: 1\nscenes: [easy.yaml]\n"
            "planners:\n  - {label: first, planner: b4p}\n");
  ASSERT_EQ(runB4p("bench " + experiment + " --out " + out).exit_code, 0);
  EXPECT_EQ(runB4p("bench " + experiment + " --resume --out " + out).exit_code, 0);
  list(kAbove);
  const CommandRun run = runB4p("bench " + experiment + " --resume --out " + out);
  EXPECT_EQ(run.exit_code, 2) << run.out;
  EXPECT_THAT(run.err, HasSubstr("has changed"));
}

}  // namespace
}  // namespace b4p::test
