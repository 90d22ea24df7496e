// SPDX-License-Identifier: BSD-3-Clause
// Experiment files: limits, thread counts, parameters by scene, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "experiments/fixtures.h"
#include "experiments/runner/experiment.h"
#include "robots/input_error.h"

namespace b4p::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class ExperimentFiles : public ::testing::Test {
 protected:
  Experiment load(const std::vector<SceneCopy::Change>& changes = {},
                  const ExperimentOverrides& overrides = {}) {
    std::string text =
        "schema: 1\nname: e\nruns: 10\ntime_limit_s: scene\nthreads: 1\nseed: 1\nscenes: [maze, grocery]\n"
        "planners:\n"
        "  - {label: a, planner: b4p, parameters: {slice: 5}, scene_parameters: {maze: {slice: 7}}}\n"
        "  - {label: b, planner: rrtconnect, threads: 1, runs: 3}\n";
    for (const auto& [from, to] : changes) text = replaced(text, from, to);
    writeText(folder_ / "e.yaml", text);
    return loadExperiment(folder_ / "e.yaml", overrides);
  }

  void expectRefused(const std::string& from, const std::string& to, const std::string& culprit,
                     const ExperimentOverrides& overrides = {}) {
    try {
      load({{from, to}}, overrides);
      ADD_FAILURE() << to;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(culprit));
    }
  }

  static std::vector<std::string> labels(const Experiment& experiment) {
    std::vector<std::string> all;
    for (const Contender& contender : experiment.contenders) all.push_back(contender.label);
    return all;
  }

  TemporaryFolder folder_;
};

TEST_F(ExperimentFiles, TakeTheTimeLimitOfTheScene) {
  const Experiment experiment = load();
  Scene scene;
  scene.budget_s = 12.5;
  const RunLimits limits = experiment.limitsFor(experiment.contenders[0], "maze", scene);
  EXPECT_EQ(limits.time_s, 12.5);
  EXPECT_FALSE(limits.checks);
  ExperimentOverrides overrides;
  overrides.time_limit_s = 3.0;
  const Experiment other = load({}, overrides);
  EXPECT_EQ(other.limitsFor(other.contenders[0], "maze", scene).time_s, 3.0);
}

TEST_F(ExperimentFiles, DeriveTheCheckLimitFromWhatACheckCosts) {
  const Experiment experiment =
      load({{"time_limit_s: scene", "time_limit_s: 120\ncheck_cost_us: 3.5\nstop: both"},
            {"threads: 1\nseed", "threads: 2\nseed"}});
  const RunLimits limits = experiment.limitsFor(experiment.contenders[0], "maze", {});
  EXPECT_EQ(limits.checks, 68571428u);
  EXPECT_EQ(limits.stop, StopRule::kBoth);
  EXPECT_EQ(experiment.limitsFor(experiment.contenders[1], "maze", {}).checks, 34285714u) << "one thread";
}

TEST_F(ExperimentFiles, StateCheckLimitsByScene) {
  const Experiment experiment =
      load({{"time_limit_s: scene", "time_limit_s: 9\ncheck_limit: {maze: 2e6, grocery: 5}"}});
  EXPECT_EQ(experiment.limitsFor(experiment.contenders[0], "maze", {}).checks, 2000000u);
  EXPECT_EQ(experiment.limitsFor(experiment.contenders[0], "grocery", {}).checks, 5u);
}

TEST_F(ExperimentFiles, GiveEachThreadCountItsLabel) {
  const std::string list = "threads: [1, 2]\nseed";
  EXPECT_THAT(labels(load({{"threads: 1\nseed", list}})), ElementsAre("a_1", "a_2", "b"));
  ExperimentOverrides overrides;
  overrides.threads = {64};
  EXPECT_THAT(labels(load({{"threads: 1\nseed", list}}, overrides)), ElementsAre("a_64", "b"));
  EXPECT_THAT(labels(load({}, overrides)), ElementsAre("a", "b"));
}

TEST_F(ExperimentFiles, ChooseTheCheckerForAllPlannersOrForOne) {
  const auto checkers = [](const Experiment& experiment) {
    return std::make_pair(experiment.contenders[0].checker, experiment.contenders[1].checker);
  };
  constexpr CheckerKind kFast = CheckerKind::kFast, kFcl = CheckerKind::kFcl;
  EXPECT_EQ(checkers(load()), std::make_pair(kFast, kFast));
  EXPECT_EQ(checkers(load({{"seed: 1", "seed: 1\nchecker: fcl"}})), std::make_pair(kFcl, kFcl));
  EXPECT_EQ(checkers(load({{"seed: 1", "seed: 1\nchecker: fcl"}, {"runs: 3", "checker: fast"}})),
            std::make_pair(kFcl, kFast));
  ExperimentOverrides overrides;
  overrides.checker = kFcl;
  EXPECT_EQ(checkers(load({}, overrides)), std::make_pair(kFcl, kFcl));
}

TEST_F(ExperimentFiles, LeaveOutThreadsBeyondTheCores) {
  if (std::thread::hardware_concurrency() >= 64) GTEST_SKIP();
  const Experiment experiment =
      load({{"threads: 1\nseed", "threads: [1, 64]\nskip_threads_beyond_cores: true\nseed"}});
  EXPECT_THAT(labels(experiment), ElementsAre("a_1", "b"));
  EXPECT_THAT(experiment.left_out_threads, ElementsAre(64u));
}

TEST_F(ExperimentFiles, MergeParametersOfAScene) {
  const Experiment experiment = load();
  EXPECT_EQ(experiment.contenders[0].parametersFor("maze").at("slice"), "7");
  EXPECT_EQ(experiment.contenders[0].parametersFor("grocery").at("slice"), "5");
}

TEST_F(ExperimentFiles, GivePlannersRunsOfTheirOwn) {
  Experiment experiment = load();
  EXPECT_EQ(experiment.runsOf(experiment.contenders[0]), 10);
  EXPECT_EQ(experiment.runsOf(experiment.contenders[1]), 3);
  ExperimentOverrides overrides;
  overrides.runs = 2;
  experiment = load({}, overrides);
  EXPECT_EQ(experiment.runsOf(experiment.contenders[1]), 2);
}

TEST_F(ExperimentFiles, KeepSomeScenes) {
  ExperimentOverrides overrides;
  overrides.scenes = {"grocery"};
  EXPECT_THAT(load({}, overrides).scenes, ElementsAre("grocery"));
  overrides.scenes = {"atlantis"};
  expectRefused("runs: 10", "runs: 10", "atlantis", overrides);
}

TEST_F(ExperimentFiles, RefuseWhatMakesNoSense) {
  const std::string time = "time_limit_s: scene";
  expectRefused(time, time + "\nstop: both", "stop");
  expectRefused(time, time + "\ncheck_limit: 0", "check_limit");
  expectRefused(time, time + "\ncheck_limit: .inf", "check_limit");
  expectRefused(time, time + "\ncheck_limit: {maze: 1}", "grocery");
  expectRefused(time, time + "\ncheck_limit: {maze: 1, grocery: 1, mars: 1}", "mars");
  expectRefused(time, time + "\ncheck_cost_us: 0", "check_cost_us");
  expectRefused(time, time + "\ncheck_cost_us: 1\ncheck_limit: 5", "check_cost_us");
  expectRefused(time, time + "\ncheck_limit: 5\nstop: never", "never");
  expectRefused(time, "time_limit_s: house", "time_limit_s");
  expectRefused("{maze: {slice: 7}}", "{mars: {slice: 7}}", "mars");
  expectRefused("runs: 3", "runs: 0", "runs");
  expectRefused("threads: 1\nseed", "threads: [1, 1]\nseed", "listed twice");
  expectRefused("threads: 1\nseed", "threads: []\nseed", "threads");
  expectRefused("threads: 1\nseed", "threads: [65]\nseed", "65");
  expectRefused("label: b", "label: a", "label");
}

TEST_F(ExperimentFiles, OfThePaperAreWellFormed) {
  const Experiment experiment =
      loadExperiment(std::string(TEST_DATA) + "/../../../experiments/paper/tables.yaml");
  EXPECT_THAT(experiment.scenes, ElementsAre("maze", "stick", "grocery"));
  EXPECT_FALSE(experiment.time_limit_s) << "each scene's budget";
  EXPECT_EQ(experiment.stop, StopRule::kBoth);
}

}  // namespace
}  // namespace b4p::test
