// SPDX-License-Identifier: BSD-3-Clause
// Placement scenes in a benchmark: objectives as scenes, every improvement recorded and verified, files that
// `b4p verify` takes, resumption, faults found before any planning.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "experiments/fixtures.h"
#include "experiments/runner/runner.h"
#include "robots/input_error.h"

namespace b4p::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kScene = "placement/panda_table_cluttered_small_crayons";
constexpr const char* kName = "placement_panda_table_cluttered_small_crayons";

class PlacementBenchmarks : public ::testing::Test {
 protected:
  /// What a file with these lines says.
  Experiment experiment(const std::string& lines, const ExperimentOverrides& overrides = {}) const {
    const std::string file = folder_ / "experiment.yaml";
    writeText(file, "schema: 1\nname: test\nruns: 1\ntime_limit_s: 3\nthreads: 1\nseed: 1\n" + lines);
    return loadExperiment(file, overrides);
  }

  static std::string scenes(const std::string& list) { return "scenes: [" + list + "]\n"; }
  static std::string planner(const std::string& rest = "") {
    return "planners: [{label: a, planner: placement" + rest + "}]\n";
  }

  std::string complaintAbout(const std::string& lines) const {
    try {
      BenchmarkRunner(experiment(lines), PlannerCatalogue::standard(), out_.path());
    } catch (const InputError& error) {
      EXPECT_FALSE(std::filesystem::exists(out_ / "experiment.json")) << "something was written";
      return error.what();
    }
    return "none";
  }

  TemporaryFolder folder_, out_;
};

TEST_F(PlacementBenchmarks, RecordAndVerifyEveryImprovementOfEachObjective) {
  const std::string lines = scenes(kScene) + "objectives: [max_clearance, min_clearance]\n" +
                            planner(", parameters: {sampling: area, local: 0}");
  BenchmarkRunner runner(experiment(lines), PlannerCatalogue::standard(), out_.path());
  runner.run();
  ASSERT_EQ(runner.records().size(), 2u);
  for (const RunRecord& record : runner.records()) {
    ASSERT_TRUE(record.placement && record.verified()) << record.scene << record.verification_failure;
    const PlacementSeries& series = *record.placement;
    EXPECT_EQ(record.scene, kName + ("-" + series.objective));
    EXPECT_EQ(series.object, "small_crayons");
    ASSERT_FALSE(series.improvements.empty());
    EXPECT_EQ(record.time_s, series.improvements.front().time_s) << "the first placement solves the scene";

    const std::string file = out_ / ("results/" + record.scene + "-a-1.json");
    EXPECT_EQ(runB4p("verify " + file).exit_code, 0);
    const auto result = nlohmann::json::parse(readFile(file));
    EXPECT_EQ(result["objective"], series.objective);
    EXPECT_EQ(result["sampling"], "area");
    EXPECT_EQ(result["parameters"]["local"], "0");
    ASSERT_EQ(result["improvements"].size(), series.improvements.size());
    for (std::size_t i = 0; i < series.improvements.size(); ++i) {
      const PlacementSeries::Improvement& one = series.improvements[i];
      EXPECT_TRUE(one.verified);
      EXPECT_EQ(one.arm, "panda");
      EXPECT_EQ(result["improvements"][i]["objective_m"], one.objective_m);
      EXPECT_EQ(result["improvements"][i]["verification"]["objective_m"], one.recomputed_m);
      EXPECT_EQ(one.objective_m < 0.0, series.objective == "min_clearance");
    }

    const std::string log = readFile(out_ / (record.scene + ".log"));
    EXPECT_THAT(log, HasSubstr("\nsampling = area\n"));
    const auto progress = log.find("progress properties");
    ASSERT_NE(progress, std::string::npos);
    EXPECT_THAT(log.substr(progress), HasSubstr("\nbest objective REAL\n"));
  }
}

TEST_F(PlacementBenchmarks, GoOnWhereTheyEnded) {
  const Experiment all = experiment(scenes(kScene) + planner());
  const auto run = [&] {
    BenchmarkRunner runner(all, PlannerCatalogue::standard(), out_.path(), EarlierRuns::kResume);
    const std::size_t before = runner.records().size();
    runner.run();
    return before;
  };
  run();
  const std::string text = readFile(out_ / "runs.jsonl");
  EXPECT_EQ(run(), 1u);
  EXPECT_EQ(readFile(out_ / "runs.jsonl"), text) << "no run is repeated";
  writeText(out_ / "runs.jsonl", text.substr(0, text.size() / 2));
  EXPECT_EQ(run(), 0u) << "half a record is none";
  const RunFile file(out_ / "runs.jsonl");
  ASSERT_EQ(file.records().size(), 1u);
  EXPECT_TRUE(file.records().front().placement.has_value());
  EXPECT_EQ(recordFrom(recordLine(file.records().front()), "").placement->improvements.size(),
            file.records().front().placement->improvements.size());

  Experiment other = all;
  other.contenders[0].parameters["exploration"] = "0.1";
  EXPECT_THROW(BenchmarkRunner(other, PlannerCatalogue::standard(), out_.path(), EarlierRuns::kResume),
               InputError);
}

TEST_F(PlacementBenchmarks, FaultsAreFoundBeforeAnyRun) {
  const std::string scene = scenes(kScene);
  EXPECT_EQ(complaintAbout(scene + planner()), "none");
  std::filesystem::remove(out_ / "experiment.json");
  std::filesystem::remove(out_ / "runs.jsonl");
  EXPECT_THAT(complaintAbout(scene + planner(", parameters: {sampling: luck}")), HasSubstr("'luck'"));
  EXPECT_THAT(complaintAbout(scene + planner(", parameters: {slice: area}")), HasSubstr("'area'"));
  EXPECT_THAT(complaintAbout(scene + planner(", parameters: {exploration: -1}")), HasSubstr("exploration"));
  EXPECT_THAT(complaintAbout(scene + planner(", parameters: {sampler: area}")), HasSubstr("sampler"));
  EXPECT_THAT(complaintAbout(scene + planner(", threads: 2")), HasSubstr("one thread"));
  EXPECT_THAT(complaintAbout(scene + "check_limit: 1000\n" + planner()), HasSubstr("limit of checks"));
  EXPECT_THAT(complaintAbout(scene + "planners: [{label: a, planner: b4p}]\n"), HasSubstr("'b4p'"));
  EXPECT_THAT(complaintAbout(scenes("maze") + planner()), HasSubstr("'placement'"));
  EXPECT_THAT(
      complaintAbout(scenes("maze") + "objectives: [min_clearance]\nplanners: [{label: a, planner: b4p}]\n"),
      HasSubstr("objectives"));
  EXPECT_THAT(complaintAbout(scene + "objectives: [nearest]\n" + planner()), HasSubstr("nearest"));
  EXPECT_THAT(complaintAbout(scene + "objectives: [max_clearance, max_clearance]\n" + planner()),
              HasSubstr("twice"));
}

TEST_F(PlacementBenchmarks, PatternsMeanTheShippedScenesTheyFit) {
  const std::string lines = scenes("placement/panda_table_*, maze") + planner();
  EXPECT_THAT(experiment(lines).scenes, ElementsAre("placement/panda_table_cluttered_large_crayons",
                                                    "placement/panda_table_cluttered_small_crayons",
                                                    "placement/panda_table_cluttered_toy_table",
                                                    "placement/panda_table_cluttered_wine_glass", "maze"));
  ExperimentOverrides overrides;
  overrides.scenes = {"placement/*_crayons"};
  EXPECT_EQ(experiment(lines, overrides).scenes.size(), 2u);
  overrides.scenes = {"placement/*_bowl"};
  EXPECT_THROW(experiment(lines, overrides), InputError);
  EXPECT_THROW(experiment(scenes("placement/no_such_*") + planner()), InputError);
  EXPECT_THROW(experiment(scenes("m*, maze") + planner()), InputError) << "a scene twice";
}

}  // namespace
}  // namespace b4p::test
