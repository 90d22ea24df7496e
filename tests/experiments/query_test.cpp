// SPDX-License-Identifier: BSD-3-Clause
// One run: time limit, preparation inside the limit, crash as a status, the stock baseline.
#include "experiments/query.h"

#include <gtest/gtest.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include <chrono>
#include <stdexcept>
#include <thread>

#include "experiments/fixtures.h"
#include "experiments/problem.h"
#include "experiments/verification/verifier.h"

namespace b4p::test {
namespace {

namespace ob = ompl::base;

QuerySettings settings(const std::string& planner, double time_limit_s = 20.0) {
  QuerySettings settings;
  settings.planner = planner;
  settings.time_limit_s = time_limit_s;
  return settings;
}

TEST(Query, StockRrtConnectSolvesAnEasySceneFromAllPicks) {
  const SceneCopy copy;
  const Scene scene = loadScene(copy.scene());
  Query query(scene, copy.scene(), PlannerCatalogue::standard(), settings("rrtconnect"), "test");
  query.solve();
  const PlanResult result = query.result();
  ASSERT_TRUE(result.solved) << result.status;
  EXPECT_EQ(query.problem().pdef->getStartStateCount(), 4u) << "one start state per grasp";
  EXPECT_TRUE(verify(scene, result).passed) << verify(scene, result).failure;
  EXPECT_GT(query.edgeChecks(), 0u);
}

TEST(Query, CountsTheConfigurationsAlongMotions) {
  const SceneCopy copy;
  Query query(loadScene(copy.scene()), copy.scene(), PlannerCatalogue::standard(), settings("b4p"), "test");
  query.solve();
  EXPECT_GT(query.edgeChecks(), 0u);
  EXPECT_GE(query.configurationsChecked(), query.edgeChecks());
}

TEST(Query, BothCheckersLeadToTheSamePath) {
  const SceneCopy copy;
  const Scene scene = loadScene(copy.scene());
  PlanResult results[2];
  for (const CheckerKind kind : {CheckerKind::kFast, CheckerKind::kFcl}) {
    QuerySettings with = settings("rrtconnect");
    with.checker = kind;
    Query query(scene, copy.scene(), PlannerCatalogue::standard(), with, "test");
    query.solve();
    results[kind == CheckerKind::kFcl] = query.result();
  }
  EXPECT_EQ(results[0].checker, "fast");
  EXPECT_EQ(results[1].checker, "fcl");
  EXPECT_FALSE(results[0].path.empty());
  EXPECT_EQ(results[0].path, results[1].path);
}

TEST(Query, StockRrtConnectKeepsItsTimeLimitAmongManyGrasps) {
  const Scene scene = loadScene("grocery");
  Query query(scene, "grocery", PlannerCatalogue::standard(), settings("rrtconnect", 1.0), "test");
  query.solve();
  EXPECT_LT(query.planner()->elapsed_s(), 5.0);
}

/// A planner that does what the test says.
class Scripted : public ob::Planner {
 public:
  Scripted(const ob::SpaceInformationPtr& si,
           std::function<void(const ob::PlannerTerminationCondition&)> script)
      : ob::Planner(si, "scripted"), script_(std::move(script)) {}
  ob::PlannerStatus solve(const ob::PlannerTerminationCondition& ptc) override {
    script_(ptc);
    return ob::PlannerStatus::TIMEOUT;
  }

 private:
  std::function<void(const ob::PlannerTerminationCondition&)> script_;
};

class Deadline : public ::testing::Test {
 protected:
  ob::PlannerStatus solve(double limit_s,
                          const std::function<void(const ob::PlannerTerminationCondition&)>& script,
                          const DeadlinePlanner::Preparation& prepare = {}) {
    problem_.pdef->addStartState(ob::ScopedState<>(problem_.si));
    planner_ = std::make_shared<DeadlinePlanner>(std::make_shared<Scripted>(problem_.si, script),
                                                 RunLimits{limit_s}, prepare, nullptr);
    planner_->setProblemDefinition(problem_.pdef);
    return planner_->solve(ob::plannerNonTerminatingCondition());
  }

  SceneCopy copy_;
  Problem problem_ = makeProblem(loadScene(copy_.scene()));
  std::shared_ptr<DeadlinePlanner> planner_;
};

TEST_F(Deadline, EndsAPlannerThatWouldGoOn) {
  solve(0.05, [](const ob::PlannerTerminationCondition& ptc) {
    while (!ptc) std::this_thread::yield();
  });
  EXPECT_GE(planner_->elapsed_s(), 0.05);
  EXPECT_LT(planner_->elapsed_s(), 2.0);
}

TEST_F(Deadline, CountsPreparationIntoTheLimit) {
  bool over = false;
  solve(
      0.02, [&over](const ob::PlannerTerminationCondition& ptc) { over = ptc; },
      [](const ob::PlannerTerminationCondition&) {
        std::this_thread::sleep_for(std::chrono::milliseconds(30));
      });
  EXPECT_TRUE(over);
}

TEST_F(Deadline, TurnsAnExceptionIntoTheStatusCrash) {
  const auto status =
      solve(1.0, [](const ob::PlannerTerminationCondition&) { throw std::runtime_error("boom"); });
  EXPECT_EQ(status, ob::PlannerStatus::CRASH);
  EXPECT_EQ(planner_->crash(), "boom");
}

}  // namespace
}  // namespace b4p::test
