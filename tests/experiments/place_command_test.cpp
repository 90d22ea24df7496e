// SPDX-License-Identifier: BSD-3-Clause
// What `b4p place` promises: improvements that rise and have been verified, one seed for one outcome, reasons
// where there is none, exit codes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "experiments/fixtures.h"
#include "experiments/placement/placement_file.h"
#include "experiments/placement/placement_query.h"
#include "experiments/scene_files/data_files.h"
#include "experiments/verification/placement_verifier.h"
#include "planners/placement/placement_path_objective.h"

namespace b4p::test {
namespace {

using ::testing::HasSubstr;

constexpr const char* kScene = "placement/panda_table_cluttered_small_crayons";

/// A shipped placement scene with changes, in a folder of its own.
std::string changedScene(const TemporaryFolder& folder,
                         const std::vector<std::pair<std::string, std::string>>& changes) {
  std::string text = readFile(std::string(B4P_SOURCE) + "/experiments/scenes/" + kScene + ".yaml");
  for (const auto& [from, to] : changes) text = replaced(text, from, to);
  const std::string file = folder / "scene.yaml";
  writeText(file, text);
  return file;
}

TEST(PlaceCommand, WritesRisingImprovementsThatHaveBeenVerified) {
  const TemporaryFolder folder;
  const std::string file = folder / "r.json";
  const CommandRun run = runB4p(std::string("place ") + kScene + " --time-limit-s 5 --out " + file);
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_EQ(run.err, "");
  const auto result = nlohmann::json::parse(readFile(file));
  EXPECT_EQ(result["scene"], kScene);
  EXPECT_TRUE(result["solved"].get<bool>());
  EXPECT_EQ(result["reason"], "");
  ASSERT_FALSE(result["improvements"].empty());
  double objective = -1.0, time_s = 0.0;
  for (const auto& improvement : result["improvements"]) {
    EXPECT_GT(improvement["objective_m"].get<double>(), objective);
    EXPECT_GE(improvement["time_s"].get<double>(), time_s);
    objective = improvement["objective_m"];
    time_s = improvement["time_s"];
    EXPECT_TRUE(improvement["verification"]["passed"].get<bool>());
    EXPECT_GT(improvement["verification"]["configurations"].get<long>(), 0);
    EXPECT_NEAR(improvement["verification"]["objective_m"].get<double>(), objective, 0.0075);
  }
  EXPECT_EQ(result["best"], result["improvements"].back());
  EXPECT_EQ(runB4p("verify " + file).exit_code, 0);
  auto better = result;
  better["improvements"][0]["objective_m"] = result["improvements"][0]["objective_m"].get<double>() + 0.02;
  better["best"] = better["improvements"].back();
  writeText(file, better.dump());
  EXPECT_EQ(runB4p("verify " + file).exit_code, 3) << "it claims more than it has";
  better["improvements"][0].erase("time_s");
  writeText(file, better.dump());
  EXPECT_EQ(runB4p("verify " + file).exit_code, 2);
}

TEST(PlaceCommand, ABestThatIsNotTheLastImprovementIsRefused) {
  const TemporaryFolder folder;
  const std::string file = folder / "r.json";
  ASSERT_EQ(runB4p(std::string("place ") + kScene + " --time-limit-s 1 --out " + file).exit_code, 0);
  const auto result = nlohmann::json::parse(readFile(file));
  const auto refused = [&](const auto& change) {
    auto other = result;
    change(other);
    writeText(file, other.dump());
    const CommandRun run = runB4p("verify " + file);
    EXPECT_EQ(run.exit_code, 2) << run.out;
    EXPECT_EQ(run.errorLines(), 1);
    return run.err;
  };
  EXPECT_THAT(refused([](auto& r) { r["best"]["path"].back()[0] = 0.0; }),
              HasSubstr("best: is not the last"));
  EXPECT_THAT(refused([](auto& r) { r["best"]["objective_m"] = 5.0; }), HasSubstr("best: is not the last"));
  EXPECT_THAT(refused([](auto& r) { r["best"] = nullptr; }), HasSubstr("best: "));
  EXPECT_THAT(refused([](auto& r) { r["objective"] = "fun"; }), HasSubstr(file + ": objective: 'fun'"));
}

TEST(PlaceCommand, SaysWhyThereIsNoPlacement) {
  const TemporaryFolder folder;
  const std::string file = folder / "r.json";
  const std::string scene =
      changedScene(folder, {{"position_m: [0, -0.1, 0], rpy", "position_m: [0, -2.1, 0], rpy"}});
  const CommandRun run = runB4p("place " + scene + " --time-limit-s 1 --out " + file);
  EXPECT_EQ(run.exit_code, 1) << run.out << run.err;
  EXPECT_THAT(run.out, HasSubstr("no placement: "));
  EXPECT_THAT(run.out, HasSubstr("out of reach"));
  const auto result = nlohmann::json::parse(readFile(file));
  EXPECT_FALSE(result["solved"].get<bool>());
  EXPECT_TRUE(result["best"].is_null());
  EXPECT_THAT(result["reason"].get<std::string>(), HasSubstr("out of reach"));
}

TEST(PlaceCommand, BadInputIsOneLineAndExitCode2) {
  const TemporaryFolder folder;
  const std::string out = " --out " + (folder / "r.json");
  for (const std::string& arguments : std::vector<std::string>{
           "no_such_scene", "maze", std::string(kScene) + " --objective nearest",
           std::string(kScene) + " --sampling luck", std::string(kScene) + " --param slice=0",
           std::string(kScene) + " --param no_such=1", std::string(kScene) + " --param sampling=luck",
           std::string(kScene) + " --param stage=2",
           std::string(kScene) + " --sampling area --param sampling=tree",
           std::string(kScene) + " --time-limit-s 0", std::string(kScene) + " --seed -1"}) {
    const CommandRun run = runB4p("place " + arguments + out);
    EXPECT_EQ(run.exit_code, 2) << arguments;
    EXPECT_EQ(run.errorLines(), 1) << run.err;
  }
  EXPECT_TRUE(folder.files().empty());
}

/// Ends at the first placement this good, so that nothing depends on how fast the machine is.
PlacementResult firstBetterThan(double objective, std::uint64_t seed) {
  PlacementQuerySettings settings;
  settings.seed = seed;
  settings.time_limit_s = 60.0;
  PlacementQuery query(loadPlacementScene(kScene), kScene, settings, "test");
  query.problem().pdef->getOptimizationObjective()->setCostThreshold(ompl::base::Cost(objective));
  return query.solve();
}

TEST(PlacementQuery, OneSeedGivesTheSamePlacements) {
  const PlacementResult first = firstBetterThan(0.05, 3), second = firstBetterThan(0.05, 3);
  ASSERT_TRUE(first.solved());
  ASSERT_EQ(first.improvements.size(), second.improvements.size());
  for (std::size_t i = 0; i < first.improvements.size(); ++i) {
    EXPECT_EQ(first.improvements[i].path, second.improvements[i].path);
    EXPECT_EQ(first.improvements[i].objective_m, second.improvements[i].objective_m);
  }
}

TEST(PlacementVerifier, FindsWhatHasBeenTamperedWith) {
  const Scene scene = loadPlacementScene(kScene);
  const PlacementResult result = firstBetterThan(0.05, 1);
  ASSERT_TRUE(result.solved());
  const PlacementVerifier verifier(scene, 1.0);
  const auto failure = [&](auto change) {
    PlacementImprovement improvement = result.improvements.back();
    change(improvement);
    const PlacementVerification outcome = verifier.verify(improvement, result.joint_names.front());
    EXPECT_EQ(outcome.passed, outcome.failure.empty());
    return outcome.failure;
  };
  EXPECT_EQ(failure([](PlacementImprovement&) {}), "");
  EXPECT_THAT(failure([](PlacementImprovement& i) { i.objective_m += 0.01; }), HasSubstr("the objective is"));
  EXPECT_THAT(failure([](PlacementImprovement& i) { i.X_WO.translation().x() += 1e-3; }),
              HasSubstr("pose stated"));
  EXPECT_THAT(failure([](PlacementImprovement& i) { i.path.front()[2] += 1e-3; }),
              HasSubstr("not at its start"));
  EXPECT_THAT(failure([](PlacementImprovement& i) { i.path.back()[0] = 10.0; }), HasSubstr("joint"));
  EXPECT_THAT(failure([](PlacementImprovement& i) { i.path.erase(i.path.begin() + 1, i.path.end()); }),
              HasSubstr("pose stated"))
      << "it never leaves the start";
  EXPECT_NE(failure([](PlacementImprovement& i) { i.path.back()[3] -= 0.3; }), "");
}

}  // namespace
}  // namespace b4p::test
