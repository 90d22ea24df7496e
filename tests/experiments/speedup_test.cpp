// SPDX-License-Identifier: BSD-3-Clause
// `b4p simulate`: runs in logical time that are verified and do not depend on the machine's cores; one worker
// makes the path of `b4p plan`; a file of runs is continued, even when it was cut off, and never mixes
// studies.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "experiments/fixtures.h"
#include "experiments/scene.h"
#include "experiments/speedup/speed_file.h"
#include "experiments/speedup/speed_run.h"
#include "planners/b4p/virtual_time_b4p.h"
#include "robots/input_error.h"

namespace b4p::test {
namespace {

using ::testing::HasSubstr;

SpeedStudy studyOf(const SceneCopy& copy) {
  SpeedStudy study;
  study.scene = copy.scene();
  study.time_limit_s = 20.0;
  return study;
}

TEST(SpeedRun, IsSolvedAndVerifiedInLogicalTimeAndInThreads) {
  const SceneCopy copy;
  const Scene scene = loadScene(copy.scene());
  for (const bool real_threads : {false, true}) {
    const SpeedCase which{real_threads, 2, 5};
    const SpeedRun run = makeSpeedRun(scene, studyOf(copy), which, "test", [](const auto*) {});
    EXPECT_TRUE(run.which == which);
    EXPECT_TRUE(run.solved);
    EXPECT_TRUE(run.verified);
    EXPECT_GT(run.steps, 0u);
    EXPECT_GT(run.time_s, 0.0);
    EXPECT_GT(run.work_s, 0.0);
  }
}

TEST(SpeedRun, OneWorkerMakesThePathOfThePlanner) {
  const SceneCopy copy;
  const Scene scene = loadScene(copy.scene());
  const auto pathOf = [&](const PlannerCatalogue& catalogue) {
    QuerySettings settings;
    settings.seed = 7;
    settings.time_limit_s = 20.0;
    Query query(scene, copy.scene(), catalogue, settings, "test");
    query.solve();
    EXPECT_TRUE(query.result().solved);
    return query.result().path;
  };
  EXPECT_EQ(pathOf(PlannerCatalogue::standard()), pathOf(virtualTimeCatalogue(20.0, [](const auto&) {})));
}

std::vector<std::string> linesOf(const std::string& file) {
  std::vector<std::string> lines(1);
  for (const char c : readFile(file))
    if (c == '\n')
      lines.emplace_back();
    else
      lines.back() += c;
  return lines;
}

TEST(Simulate, ContinuesAFileThatWasCutOff) {
  const SceneCopy copy;
  const std::string file = copy.folder() / "s.json";
  const std::string command = "simulate " + copy.scene() + " --workers 1,3 --out " + file;
  const CommandRun first = runB4p(command + " --runs 2 --seed 4");
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("3 workers, seed 5: solved"));
  const auto lines = linesOf(file);
  ASSERT_EQ(lines.size(), 6u);  // the study, four runs, and nothing after the last end of line

  // The last run loses its end; the third seed is new.
  const std::string text = readFile(file);
  writeText(file, text.substr(0, text.size() - 20));
  const CommandRun second = runB4p(command + " --runs 3 --seed 4");
  ASSERT_EQ(second.exit_code, 0) << second.err;
  const auto continued = linesOf(file);
  ASSERT_EQ(continued.size(), 8u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(continued[i], lines[i]);
  EXPECT_THAT(continued[4], HasSubstr("\"workers\":3,\"seed\":5,\"solved\":true,\"verified\":true"));
  EXPECT_EQ(second.out.find("seed 4:"), std::string::npos);

  EXPECT_EQ(runB4p(command + " --runs 1 --real-threads").exit_code, 0);
  EXPECT_THAT(linesOf(file).at(7), HasSubstr("\"kind\":\"threads\""));
}

TEST(Simulate, UnsolvedRunsAreRecordedAsSuch) {
  const std::vector<SceneCopy::Change> closed{{"size_m: [0.1, 1.2, 0.1]", "size_m: [0.1, 9.0, 0.1]"}};
  const SceneCopy copy(closed);
  const std::string file = copy.folder() / "s.json";
  for (const char* planner : {"b4p", "b4p-paper"}) {
    const CommandRun run = runB4p("simulate " + copy.scene() + " --workers 4 --runs 1 --time-limit-s 0.1" +
                                  " --planner " + planner + " --out " + file + planner);
    EXPECT_EQ(run.exit_code, 1) << run.err;
    EXPECT_THAT(linesOf(file + planner).at(1), HasSubstr("\"solved\":false,\"verified\":false"));
  }
}

TEST(Simulate, RefusesWhatIsNotOfItsStudy) {
  const SceneCopy copy;
  const std::string file = copy.folder() / "s.json";
  const std::string command = "simulate " + copy.scene() + " --runs 1 --out " + file;
  const auto refused = [&](const std::string& options, const std::string& culprit) {
    const CommandRun run = runB4p(command + options);
    EXPECT_EQ(run.exit_code, 2) << options;
    EXPECT_EQ(run.errorLines(), 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr(culprit));
  };
  for (const char* workers : {"0", "65", "2,2", "two", "1.5"})
    refused(std::string(" --workers ") + workers, "--workers");
  refused(" --planner rrtconnect", "b4p-paper");
  refused(" --param relaxed=2", "relaxed");
  refused(" --time-limit-s 0", "--time-limit-s");
  EXPECT_THAT(copy.folder().files(), ::testing::Not(::testing::Contains("s.json")));

  ASSERT_EQ(runB4p(command + " --workers 1").exit_code, 0);
  refused(" --workers 1 --planner b4p-paper", "planner");
  refused(" --workers 1 --time-limit-s 3", "time_limit_s");
  refused(" --workers 1 --param slice=7", "parameters");
  writeText(file, readFile(file) + "{\"kind\": \"guess\"}\n");
  refused(" --workers 1", "line 3");
}

}  // namespace
}  // namespace b4p::test
