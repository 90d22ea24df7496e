// SPDX-License-Identifier: BSD-3-Clause
// What the b4p command promises when its input is sound: exit codes, files, seeds, interrupts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <regex>
#include <thread>

#include "experiments/fixtures.h"
#include "experiments/result.h"

namespace b4p::test {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

std::string withoutTimings(const std::string& json) {
  return std::regex_replace(json, std::regex("\"planning_time_s\": *[^,}]*"), "");
}

TEST(Command, ListNamesScenesAndPlanners) {
  const CommandRun run = runB4p("list");
  EXPECT_EQ(run.exit_code, 0);
  for (const char* name : {"maze", "stick", "grocery", "b4p", "b4p-paper", "rrtconnect", "repair_iterations"})
    EXPECT_THAT(run.out, HasSubstr(name));
}

TEST(Command, HelpStatesUnitsAndDefaults) {
  const CommandRun run = runB4p("plan --help");
  EXPECT_EQ(run.exit_code, 0);
  for (const char* text : {"--time-limit-s", "seconds", "--seed", "=1", "--threads", "--out", "result.json"})
    EXPECT_THAT(run.out, HasSubstr(text));
}

TEST(Command, PlanWritesAVerifiedResultThatVerifyAccepts) {
  const SceneCopy copy;
  for (const char* planner : {"b4p", "b4p-paper", "rrtconnect"}) {
    const std::string file = copy.folder() / "r.json";
    const CommandRun run = runB4p("plan " + copy.scene() + " --planner " + planner + " --out " + file);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    const PlanResult result = readResult(file);
    EXPECT_TRUE(result.solved);
    EXPECT_TRUE(result.verification.passed);
    EXPECT_EQ(runB4p("verify " + file).exit_code, 0);
  }
}

TEST(Command, OneThreadAndOneSeedGiveTheSameBytes) {
  const SceneCopy copy;
  const auto plan = [&](const std::string& planner, int seed) {
    const std::string file = copy.folder() / "r.json";
    EXPECT_EQ(runB4p("plan " + copy.scene() + " --planner " + planner + " --seed " + std::to_string(seed) +
                     " --out " + file)
                  .exit_code,
              0);
    return withoutTimings(readFile(file));
  };
  for (const char* planner : {"b4p", "b4p-paper", "rrtconnect"}) {
    EXPECT_EQ(plan(planner, 3), plan(planner, 3)) << planner;
    EXPECT_NE(plan(planner, 3), plan(planner, 4)) << planner;
  }
}

TEST(Command, GenerateWritesAnInstanceThatPlanReads) {
  const TemporaryFolder folder;
  const std::string file = folder / "easy_maze.yaml";
  const CommandRun run =
      runB4p("generate maze --seed 3 --difficulty 0 --set passages=1 --name easy_maze --out " + file);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  for (const char* part : {"family: maze", "seed: 3", "difficulty: 0", "passages: 1", "name: easy_maze"})
    EXPECT_THAT(readFile(file), HasSubstr(part));
  const std::string result = folder / "r.json";
  const int planned = runB4p("plan " + file + " --time-limit-s 0.2 --out " + result).exit_code;
  EXPECT_TRUE(planned == 0 || planned == 1) << planned;
  EXPECT_EQ(readResult(result).scene, file);
}

TEST(Command, GenerateListsParametersWithTheirRanges) {
  const CommandRun run = runB4p("generate --list");
  EXPECT_EQ(run.exit_code, 0);
  for (const char* part : {"maze", "stick", "grocery", "gap_width_m: ", "0.075 ... 0.3", "(count)"})
    EXPECT_THAT(run.out, HasSubstr(part));
}

TEST(Command, ForestsHoldBothSides) {
  const SceneCopy copy;
  const std::string file = copy.folder() / "f.json";
  ASSERT_EQ(runB4p("plan " + copy.scene() + " --out " + copy.folder() / "r.json --forests " + file).exit_code,
            0);
  const std::string text = readFile(file);
  EXPECT_THAT(text, HasSubstr("\"scene\":\"" + copy.scene() + "\""));
  for (const char* part : {"\"schema\":1", "\"side\":0", "\"side\":1", "\"parent\":-1"})
    EXPECT_THAT(text, HasSubstr(part));
  EXPECT_THAT(text, ContainsRegex("\"openings_m\":\\{\"[0-9]+\":[0-9.]+"));
  EXPECT_THAT(text, ContainsRegex("\"parent\":[0-9]"));
}

TEST(Command, UnsolvedSceneEndsWithOneInsideItsTimeLimit) {
  // The wall reaches across all that the robot reaches.
  const std::vector<SceneCopy::Change> closed{{"size_m: [0.1, 1.2, 0.1]", "size_m: [0.1, 9.0, 0.1]"}};
  const SceneCopy copy(closed);
  for (const char* planner : {"b4p", "b4p-paper", "rrtconnect"}) {
    const std::string file = copy.folder() / "r.json";
    const CommandRun run =
        runB4p("plan " + copy.scene() + " --time-limit-s 0.3 --planner " + planner + " --out " + file);
    EXPECT_EQ(run.exit_code, 1) << run.err;
    const PlanResult result = readResult(file);
    EXPECT_FALSE(result.solved);
    EXPECT_GE(result.planning_time_s, 0.3);
    EXPECT_LT(result.planning_time_s, 3.0) << planner;
    EXPECT_EQ(runB4p("verify " + file).exit_code, 1);
  }
}

TEST(Command, TamperedResultEndsWithThree) {
  const SceneCopy copy;
  const std::string file = copy.folder() / "r.json";
  ASSERT_EQ(runB4p("plan " + copy.scene() + " --out " + file).exit_code, 0);
  PlanResult result = readResult(file);
  result.path.insert(result.path.begin() + 1, {1.0, -0.5, 0.0});  // inside the wall
  writeResult(file, result);
  const CommandRun run = runB4p("verify " + file);
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.out, HasSubstr("FAILED"));
}

TEST(Command, VerifyLooksAtEveryFile) {
  const SceneCopy copy;
  const std::string good = copy.folder() / "good.json", bad = copy.folder() / "bad.json";
  ASSERT_EQ(runB4p("plan " + copy.scene() + " --out " + good).exit_code, 0);
  PlanResult result = readResult(good);
  result.path.insert(result.path.begin() + 1, {1.0, -0.5, 0.0});
  writeResult(bad, result);
  const CommandRun unreadable = runB4p("verify /nowhere/r.json " + good);
  EXPECT_EQ(unreadable.exit_code, 2);
  EXPECT_EQ(unreadable.errorLines(), 1);
  EXPECT_THAT(unreadable.out, HasSubstr("good.json: passed"));
  EXPECT_EQ(runB4p("verify /nowhere/r.json " + bad + " " + good).exit_code, 3);
}

TEST(Command, VerifyRefusesAFileThatContradictsItself) {
  const SceneCopy copy;
  const std::string file = copy.folder() / "r.json";
  ASSERT_EQ(runB4p("plan " + copy.scene() + " --out " + file).exit_code, 0);
  PlanResult result = readResult(file);
  result.status = "Timeout";
  writeResult(file, result);
  const CommandRun run = runB4p("verify " + file);
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.out, HasSubstr("FAILED"));
}

/// Changes that make edges too long to be checked, so that the checker throws while planning.
const std::vector<SceneCopy::Change> kEndlessRails{
    {"lower=\"-1.0\" upper=\"3.0\"", "lower=\"-1e6\" upper=\"1e6\""}};

std::string quickExperiment(const TemporaryFolder& folder) {
  const std::string file = folder / "quick.yaml";
  writeText(file,
            "schema: 1\nname: quick\nruns: 7\ntime_limit_s: 5\nthreads: 1\nseed: 1\nscenes: [easy.yaml]\n"
            "planners:\n  - {label: first, planner: b4p}\n");
  return file;
}

TEST(Command, CrashEndsWithFourAndItsReason) {
  const SceneCopy copy(kEndlessRails, "planar.urdf");
  writeText(copy.scene(), replaced(readFile(copy.scene()), "edge_step_m: 0.02", "edge_step_m: 1e-5"));
  const CommandRun plan = runB4p("plan " + copy.scene() + " --out " + copy.folder() / "r.json");
  EXPECT_EQ(plan.exit_code, 4);
  EXPECT_THAT(plan.err, HasSubstr("too many samples"));
  const CommandRun bench =
      runB4p("bench " + quickExperiment(copy.folder()) + " --runs 1 --out " + copy.folder() / "out");
  EXPECT_EQ(bench.exit_code, 4) << bench.err;
  // OMPL's benchmark asks the checker for statistics before it plans, so the exception may come there
  // already.
  EXPECT_THAT(bench.out + bench.err, HasSubstr("too many samples"));
}

TEST(Command, BenchOptionsReplaceWhatTheFileSays) {
  const SceneCopy copy;
  const std::string out = copy.folder() / "out";
  const CommandRun run = runB4p("bench " + quickExperiment(copy.folder()) +
                                " --runs 1 --seed 9 --threads 2 --time-limit-s 4 --out " + out);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const std::string summary = readFile(out + "/summary.md");
  for (const char* part : {"1 of 1 planned runs", "time limit per run: 4 s", "\nseed: 9\n", "threads 2"})
    EXPECT_THAT(summary, HasSubstr(part));
}

TEST(Command, BenchWithoutAnySolutionEndsWithOne) {
  const std::vector<SceneCopy::Change> closed{{"size_m: [0.1, 1.2, 0.1]", "size_m: [0.1, 9.0, 0.1]"}};
  const SceneCopy copy(closed);
  EXPECT_EQ(runB4p("bench " + quickExperiment(copy.folder()) + " --runs 1 --time-limit-s 0.2 --out " +
                   copy.folder() / "out")
                .exit_code,
            1);
}

/// An experiment with one run that ends at once and one that would take for ever.
std::string slowExperiment(const TemporaryFolder& folder) {
  const std::string file = folder / "slow.yaml";
  const std::string blocked =
      replaced(replaced(readFile(folder / "easy.yaml"), "size_m: [0.1, 1.2, 0.1]", "size_m: [0.1, 9.0, 0.1]"),
               "name: easy", "name: blocked");
  writeText(folder / "blocked.yaml", blocked);
  writeText(file,
            "schema: 1\nname: slow\nruns: 1\ntime_limit_s: 600\nthreads: 1\nseed: 1\n"
            "scenes: [easy.yaml, blocked.yaml]\nplanners:\n  - {label: first, planner: b4p}\n");
  return file;
}

TEST(Command, InterruptedBenchmarkKeepsFinishedRuns) {
  const SceneCopy copy;
  const std::string experiment = slowExperiment(copy.folder());
  const std::string out = copy.folder() / "out";
  const std::string pid_file = copy.folder() / "pid";
  CommandRun run;
  std::thread command([&] { run = runB4p("bench " + experiment + " --out " + out, pid_file); });
  // The second run begins when the first one's summary is there.
  for (int i = 0; i < 600 && !std::filesystem::exists(out + "/summary.md"); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  const int pid = std::stoi(readFile(pid_file));
  ::kill(pid, SIGINT);
  command.join();
  EXPECT_EQ(run.exit_code, 130) << run.err;
  EXPECT_THAT(readFile(out + "/easy.log"), HasSubstr("1 runs\n"));
  EXPECT_FALSE(std::filesystem::exists(out + "/blocked.log"));
  EXPECT_THAT(readFile(out + "/summary.md"), HasSubstr("1 of 2 planned runs recorded"));
  EXPECT_EQ(readResult(out + "/results/easy-first-1.json").solved, true);
  for (const std::string& file : copy.folder().files())
    EXPECT_EQ(file.find(".part"), std::string::npos) << file;
}

TEST(Command, PlansAndVerifiesReaching) {
  const TemporaryFolder folder;
  const std::string file = folder / "r.json";
  const CommandRun run = runB4p("plan table/above_2 --planner ik-rrt --time-limit-s 30 --out " + file);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(readResult(file).X_WT_reached);
  EXPECT_EQ(runB4p("verify " + file).exit_code, 0);
  writeText(file, std::regex_replace(readFile(file), std::regex("-0.760123541"), "-0.760123641"));
  EXPECT_EQ(runB4p("verify " + file).exit_code, 3);
}

TEST(Command, RefusesWhatReachingHasNot) {
  const TemporaryFolder folder;
  for (const std::string command :
       {"certify table/above_1 --out ", "simulate table/above_1 --out ",
        "plan table/above_1 --planner rrt-shared --out ", "plan maze --planner jplus-rrt --out "}) {
    const CommandRun run = runB4p(command + (folder / "out"));
    EXPECT_EQ(run.exit_code, 2) << command;
    EXPECT_EQ(run.errorLines(), 1) << run.err;
    EXPECT_THAT(run.err, ::testing::AnyOf(HasSubstr("reach"), HasSubstr("pick and place")));
  }
  EXPECT_TRUE(folder.files().empty());
}

}  // namespace
}  // namespace b4p::test
