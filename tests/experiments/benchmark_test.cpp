// SPDX-License-Identifier: BSD-3-Clause
// Every planned run is recorded, with the project's own columns, whatever the planner does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <sstream>
#include <stdexcept>

#include "experiments/fixtures.h"
#include "experiments/runner/runner.h"
#include "robots/input_error.h"

namespace b4p::test {
namespace {

namespace ob = ompl::base;
using ::testing::HasSubstr;

class Crashing : public ob::Planner {
 public:
  explicit Crashing(const ob::SpaceInformationPtr& si) : ob::Planner(si, "crashing") {
    addPlannerProgressProperty("iterations INTEGER", [] { return "0"; });
  }
  ob::PlannerStatus solve(const ob::PlannerTerminationCondition&) override { throw std::logic_error("boom"); }
};

class Benchmarks : public ::testing::Test {
 protected:
  Experiment experiment(int runs, const std::vector<std::string>& planners) const {
    Experiment experiment = benchmarkOf(copy_, runs);
    for (const std::string& planner : planners)
      experiment.contenders.push_back({"c" + std::to_string(experiment.contenders.size()), planner, 1, {}});
    return experiment;
  }

  static PlannerCatalogue catalogue() {
    PlannerCatalogue catalogue = PlannerCatalogue::standard();
    catalogue.add({"crashing", "", 1,
                   [](const ob::SpaceInformationPtr& si) { return std::make_shared<Crashing>(si); }});
    return catalogue;
  }

  SceneCopy copy_;
  TemporaryFolder out_;
};

TEST_F(Benchmarks, RecordEveryPlannedRun) {
  BenchmarkRunner runner(experiment(3, {"b4p", "rrtconnect", "b4p-paper"}), catalogue(), out_.path());
  runner.run();
  EXPECT_EQ(runner.plannedRuns(), 9u);
  ASSERT_EQ(runner.records().size(), 9u);
  EXPECT_EQ(runner.records()[1].label, "c1") << "run 1 of every planner comes before run 2 of any";
  for (const RunRecord& record : runner.records()) EXPECT_TRUE(record.verified()) << record.label;
  const std::string log = readFile(out_ / "easy.log");
  EXPECT_THAT(log, HasSubstr("Experiment easy\n"));
  EXPECT_THAT(log, HasSubstr("\n3 planners\nc0\n"));
  for (const char* column : {"grasp id INTEGER", "repairs tried INTEGER", "repairs succeeded INTEGER",
                             "validity checks INTEGER", "edge checks INTEGER", "verified BOOLEAN",
                             "seed INTEGER", "threads INTEGER", "time to verified path REAL"}) {
    const auto first = log.find(std::string("\n") + column + "\n");
    ASSERT_NE(first, std::string::npos) << column;
    EXPECT_NE(log.find(column, first + 2), std::string::npos) << column << " is there for every planner";
  }
  EXPECT_THAT(readFile(out_ / "summary.md"), HasSubstr("3 of 3"));
  EXPECT_THAT(readFile(out_ / "summary.md"), HasSubstr("commit: "));
}

TEST_F(Benchmarks, WriteAVerifiedResultFilePerSolvedRun) {
  BenchmarkRunner runner(experiment(2, {"b4p"}), catalogue(), out_.path());
  runner.run();
  std::set<std::uint64_t> seeds;
  for (const char* name : {"results/easy-c0-1.json", "results/easy-c0-2.json"}) {
    const PlanResult result = readResult(out_ / name);
    EXPECT_TRUE(result.verification.passed);
    seeds.insert(result.seed);
  }
  EXPECT_EQ(seeds.size(), 2u) << "each run has a seed of its own";
}

TEST_F(Benchmarks, AreReproducibleOnOneThread) {
  const auto paths = [&] {
    const TemporaryFolder out;
    BenchmarkRunner runner(experiment(2, {"b4p", "rrtconnect"}), catalogue(), out.path());
    runner.run();
    std::vector<std::vector<std::vector<double>>> all;
    for (const RunRecord& record : runner.records())
      all.push_back(
          readResult(out / ("results/easy-" + record.label + "-" + std::to_string(record.run) + ".json"))
              .path);
    return all;
  };
  EXPECT_EQ(paths(), paths());
}

TEST_F(Benchmarks, RecordACrashAsARun) {
  BenchmarkRunner runner(experiment(2, {"crashing", "b4p"}), catalogue(), out_.path());
  runner.run();
  ASSERT_EQ(runner.records().size(), 4u);
  EXPECT_TRUE(runner.records()[0].crashed);
  EXPECT_EQ(runner.records()[0].status, "Crash");
  EXPECT_EQ(runner.records()[0].crash, "boom");
  EXPECT_TRUE(runner.anyCrashed());
  EXPECT_THAT(readFile(out_ / "summary.md"), HasSubstr("Run 1 of c0 crashed: boom"));
  EXPECT_TRUE(runner.records()[1].verified());
  EXPECT_THAT(readFile(out_ / "easy.log"), HasSubstr("\nc0\n"));
  EXPECT_FALSE(std::filesystem::exists(out_ / "results/easy-c0-1.json"));
}

TEST_F(Benchmarks, DoNotMixWithEarlierOnes) {
  BenchmarkRunner(experiment(2, {"b4p"}), catalogue(), out_.path()).run();
  writeText(out_ / "notes.txt", "");
  writeText(out_ / "results/notes.txt", "");
  EXPECT_THROW(BenchmarkRunner(experiment(1, {"b4p"}), catalogue(), out_.path()), InputError);
  EXPECT_TRUE(std::filesystem::exists(out_ / "results/easy-c0-2.json"));
  BenchmarkRunner(experiment(1, {"b4p"}), catalogue(), out_.path(), EarlierRuns::kRemove).run();
  EXPECT_EQ(out_.files(),
            (std::vector<std::string>{"easy.log", "experiment.json", "notes.txt", "results/easy-c0-1.json",
                                      "results/notes.txt", "runs.jsonl", "summary.md"}));
}

TEST_F(Benchmarks, CountFailuresAsLongerThanTheLimit) {
  writeText(copy_.folder() / "blocked.yaml",
            replaced(readFile(copy_.scene()), "size_m: [0.1, 1.2, 0.1]", "size_m: [0.1, 9.0, 0.1]"));
  Experiment blocked = experiment(1, {"b4p", "rrtconnect"});
  blocked.scenes = {copy_.folder() / "blocked.yaml"};
  blocked.time_limit_s = 0.12;
  BenchmarkRunner runner(blocked, catalogue(), out_.path());
  runner.run();
  for (const RunRecord& record : runner.records()) EXPECT_FALSE(record.solved);
  EXPECT_THAT(runner.report(), HasSubstr("| 0 of 1 | 0 of 0 | 0 | > 0.12 |"));
  EXPECT_THAT(readFile(out_ / "easy.log"), HasSubstr("nan"));
}

}  // namespace
}  // namespace b4p::test
