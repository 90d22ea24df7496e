// SPDX-License-Identifier: BSD-3-Clause
// A benchmark that was ended by whatever goes on without repeating or losing a run, and only with the
// settings it was begun with. A run ends by time, by work, or by both.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <tuple>

#include "experiments/fixtures.h"
#include "experiments/runner/runner.h"
#include "robots/input_error.h"

namespace b4p::test {
namespace {

using ::testing::HasSubstr;

class Resumption : public ::testing::Test {
 protected:
  Experiment experiment(int runs) const {
    Experiment experiment = benchmarkOf(copy_, runs);
    experiment.contenders = {{"first", "b4p", 1, {}}, {"second", "rrtconnect", 1, {}}};
    return experiment;
  }

  /// Runs whatever is missing, and says how many runs the folder had before.
  std::size_t run(const Experiment& experiment, EarlierRuns earlier = EarlierRuns::kResume) const {
    BenchmarkRunner runner(experiment, PlannerCatalogue::standard(), out_.path(), earlier);
    const std::size_t before = runner.records().size();
    runner.run();
    return before;
  }

  using Outcome = std::tuple<std::string, int, std::uint64_t, bool, int, std::uint64_t, std::uint64_t>;

  /// What is recorded of all runs but for their times, in the order they were made.
  std::vector<Outcome> outcomes() const {
    std::vector<Outcome> all;
    const RunFile file(runs());
    for (const RunRecord& r : file.records())
      all.emplace_back(r.label, r.run, r.seed, r.verified(), r.grasp_id, r.checks, r.edge_checks);
    return all;
  }

  void expectRefused(const Experiment& other, const std::string& culprit) const {
    const std::string before = readFile(settings());
    try {
      run(other);
      ADD_FAILURE() << culprit << " differs";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(culprit));
    }
    EXPECT_EQ(readFile(settings()), before);
    EXPECT_EQ(outcomes().size(), 2u);
  }

  std::string runs() const { return out_ / "runs.jsonl"; }
  std::string settings() const { return out_ / "experiment.json"; }

  SceneCopy copy_;
  TemporaryFolder out_;
};

TEST_F(Resumption, LeavesTheSameRunsAsAnUninterruptedBenchmark) {
  run(experiment(3));
  const std::vector<Outcome> whole = outcomes();
  const std::string text = readFile(runs());
  ASSERT_EQ(whole.size(), 6u);
  std::vector<std::size_t> ends;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', end + 1))
    ends.push_back(end);
  // Killed in the middle of a record, just before its end, and between two records.
  for (const auto& [kept, complete] :
       std::vector<std::pair<std::size_t, std::size_t>>{{ends[2] + 40, 3}, {ends[4], 4}, {ends[0] + 1, 1}}) {
    writeText(runs(), text.substr(0, kept));
    std::filesystem::remove(out_ / "easy.log");
    EXPECT_EQ(run(experiment(3)), complete);
    EXPECT_EQ(outcomes(), whole) << "kept " << kept << " bytes";
    EXPECT_THAT(readFile(out_ / "easy.log"), HasSubstr("\n2 planners\nfirst\n"));
    EXPECT_THAT(readFile(out_ / "summary.md"), HasSubstr("3 of 3"));
  }
}

TEST_F(Resumption, RepeatsNothingWhenAllIsDone) {
  run(experiment(2), EarlierRuns::kRefuse);
  const std::string text = readFile(runs());
  const std::string log = readFile(out_ / "easy.log");
  std::filesystem::remove(out_ / "easy.log");
  EXPECT_EQ(run(experiment(2)), 4u);
  EXPECT_EQ(readFile(runs()), text);
  const std::string again = readFile(out_ / "easy.log");
  EXPECT_EQ(again.substr(again.find("\nfirst\n")), log.substr(log.find("\nfirst\n")))
      << "all runs with their progress";
}

TEST_F(Resumption, TakesMoreRunsAndPlanners) {
  run(experiment(1), EarlierRuns::kRefuse);
  Experiment more = experiment(2);
  more.contenders.erase(more.contenders.begin());
  more.contenders.push_back({"third", "b4p-paper", 1, {}});
  EXPECT_EQ(run(more), 2u);
  EXPECT_EQ(outcomes().size(), 5u);
  const std::string log = readFile(out_ / "easy.log");
  for (const char* label : {"\nfirst\n", "\nsecond\n", "\nthird\n"}) EXPECT_THAT(log, HasSubstr(label));
  EXPECT_EQ(run(experiment(1)), 5u) << "fewer runs lose none";
  EXPECT_EQ(outcomes().size(), 5u);
}

TEST_F(Resumption, RefusesOtherSettings) {
  run(experiment(1), EarlierRuns::kRefuse);
  Experiment other = experiment(1);
  other.seed = 2;
  expectRefused(other, "seed: is 1 in this folder, 2 in the experiment");
  other = experiment(1);
  other.time_limit_s = 21.0;
  expectRefused(other, "scenes.easy.time_limit_s");
  other = experiment(1);
  other.clock = RunClock::kProcessor;
  expectRefused(other, "clock: is \"elapsed\" in this folder, \"processor\" in the experiment");
  other = experiment(1);
  other.check_cost_us = 3.5;
  expectRefused(other, "check_cost_us");
  other = experiment(1);
  other.contenders[0].parameters["slice"] = "10";
  expectRefused(other, "planners.first.parameters");
  other = experiment(1);
  other.contenders[0].checker = CheckerKind::kFcl;
  expectRefused(other, "planners.first.checker");
  other = experiment(1);
  other.contenders[1].planner = "b4p";
  expectRefused(other, "planners.second.planner");
  writeText(copy_.scene(), readFile(copy_.scene()) + "# changed\n");
  expectRefused(experiment(1), "scenes.easy.scene_file: has changed");
}

TEST_F(Resumption, RefusesWhatItDidNotWrite) {
  run(experiment(1), EarlierRuns::kRefuse);
  const std::string text = readFile(runs());
  writeText(runs(), text + text);
  EXPECT_THROW(run(experiment(1)), InputError) << "a run twice";
  writeText(runs(), "{}\n" + text);
  EXPECT_THROW(run(experiment(1)), InputError) << "no record";
  writeText(runs(), text);
  std::filesystem::remove(settings());
  EXPECT_THROW(run(experiment(1)), InputError) << "no settings";
}

TEST_F(Resumption, IsOneProcessAtATime) {
  run(experiment(1), EarlierRuns::kRefuse);
  const RunFile held(runs());
  EXPECT_THROW(run(experiment(1)), InputError);
}

TEST_F(Resumption, BeginsInAnEmptyFolder) {
  EXPECT_EQ(run(experiment(1)), 0u);
  EXPECT_EQ(outcomes().size(), 2u);
}

TEST(RunRecords, ReadBackAsWritten) {
  RunRecord record;
  record.scene = "maze";
  record.label = "a";
  record.run = 3;
  record.limits = {120.0, 7, StopRule::kBoth};
  record.time_s = 0.1 + 0.2;
  record.checks = (std::uint64_t{1} << 60) + 1;
  record.crash = "two\nlines \xff";
  record.ompl.progress_names = {"time REAL", "nodes INTEGER"};
  record.ompl.progress = {{{"time REAL", "0.1"}, {"nodes INTEGER", "5"}}, {{"time REAL", "0.2"}}};
  const std::string line = recordLine(record);
  EXPECT_EQ(line.find('\n'), std::string::npos);
  const RunRecord read = recordFrom(line, "here");
  EXPECT_EQ(recordLine(read), line);
  EXPECT_EQ(read.time_s, record.time_s);
  EXPECT_EQ(read.checks, record.checks);
  EXPECT_EQ(read.limits.checks, record.limits.checks);
  EXPECT_EQ(read.limits.stop, StopRule::kBoth);
  EXPECT_EQ(read.ompl.progress, record.ompl.progress);
}

TEST(TimeLeft, FollowsEachPlannersOwnRuns) {
  RunRecord quick;
  quick.scene = "maze";
  quick.label = "quick";
  quick.wall_s = 2.0;
  const RunLimits limits{100.0, 5, StopRule::kBoth};
  const TimeLeft left = timeLeft({{"maze", "quick", limits}, {"maze", "slow", limits}}, {quick, quick});
  EXPECT_DOUBLE_EQ(left.about_s, 2.0 + 100.0);
  EXPECT_DOUBLE_EQ(left.at_most_s, 2.0 * limits.longest_s());
  EXPECT_EQ(durationText(-1.0), "0 s");
  EXPECT_EQ(durationText(7500.0), "2 h 5 min");
}

/// Runs a planner on a scene that cannot be solved until a limit ends it.
class Limits : public ::testing::Test {
 protected:
  RunRecord run(double time_s, std::uint64_t checks, StopRule stop, unsigned threads = 1,
                RunClock clock = RunClock::kElapsed) {
    writeText(copy_.folder() / "blocked.yaml",
              replaced(readFile(copy_.scene()), "size_m: [0.1, 1.2, 0.1]", "size_m: [0.1, 9.0, 0.1]"));
    Experiment experiment;
    experiment.file = experiment.name = "test";
    experiment.scenes = {copy_.folder() / "blocked.yaml"};
    experiment.contenders = {{"a", "b4p", threads, {}}};
    experiment.time_limit_s = time_s;
    experiment.check_limits[experiment.scenes.front()] = checks;
    experiment.stop = stop;
    experiment.clock = clock;
    BenchmarkRunner runner(experiment, PlannerCatalogue::standard(), out_.path(), EarlierRuns::kRemove);
    runner.run();
    EXPECT_FALSE(runner.records().front().solved);
    return runner.records().front();
  }

  static constexpr std::uint64_t kFew = 5000, kNever = 1000000000000;
  SceneCopy copy_;
  TemporaryFolder out_;
};

TEST_F(Limits, EitherEndsByTheWorkWhenItIsDoneFirst) {
  const RunRecord record = run(60.0, kFew, StopRule::kEither, 2);
  EXPECT_GE(record.checks, kFew);
  EXPECT_LT(record.time_s, 30.0);
  EXPECT_GT(record.cpu_s, 0.0);
}

TEST_F(Limits, EitherEndsByTheTimeWhenItIsUpFirst) {
  const RunRecord record = run(0.05, kNever, StopRule::kEither);
  EXPECT_GE(record.time_s, 0.05);
  EXPECT_LT(record.time_s, 2.0);
}

TEST_F(Limits, ProcessorTimeIsThatOfTheProcess) {
  const RunRecord record = run(0.3, kNever, StopRule::kEither, 1, RunClock::kProcessor);
  EXPECT_GE(record.time_s, 0.3);
  EXPECT_NEAR(record.cpu_s, record.time_s, 0.1);
  EXPECT_EQ(recordFrom(recordLine(record), "").limits.clock, RunClock::kProcessor);
}

TEST_F(Limits, BothGoesOnUntilTheTimeIsUp) {
  const RunRecord record = run(0.3, 1, StopRule::kBoth);
  EXPECT_GE(record.time_s, 0.3);
  EXPECT_GE(record.checks, 1u);
}

TEST_F(Limits, BothGoesOnUntilTheWorkIsDone) {
  const std::uint64_t checks = 2 * run(0.3, 1, StopRule::kBoth).checks;
  const RunRecord record = run(0.3, checks, StopRule::kBoth);
  EXPECT_TRUE(record.checks >= checks || record.time_s >= record.limits.longest_s());
  EXPECT_GT(record.time_s, 0.3);
}

TEST_F(Limits, BothDoesNotGoOnForever) {
  const RunRecord record = run(0.02, kNever, StopRule::kBoth);
  EXPECT_GE(record.time_s, record.limits.longest_s());
  EXPECT_LT(record.time_s, 2.0);
}

}  // namespace
}  // namespace b4p::test
