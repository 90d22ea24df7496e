// SPDX-License-Identifier: BSD-3-Clause
// Planners by name, with parameters that are taken as they are meant or refused.
#include "experiments/planners.h"

#include <gtest/gtest.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Console.h>

#include "robots/input_error.h"

namespace b4p::test {
namespace {

namespace ob = ompl::base;

class Planners : public ::testing::Test {
 protected:
  void SetUp() override { ompl::msg::noOutputHandler(); }

  ob::PlannerPtr make(const std::string& name, const PlannerParameters& parameters,
                      unsigned threads = 1) const {
    return makePlanner(catalogue_.find(name, "test"), parameters, threads, si_, "test");
  }

  std::string value(const ob::PlannerPtr& planner, const std::string& parameter) const {
    std::string text;
    EXPECT_TRUE(planner->params().getParam(parameter, text));
    return text;
  }

  PlannerCatalogue catalogue_ = PlannerCatalogue::standard();
  ob::SpaceInformationPtr si_ =
      std::make_shared<ob::SpaceInformation>(std::make_shared<ob::RealVectorStateSpace>(2));
};

TEST_F(Planners, TakeParametersAndThreads) {
  const auto planner = make("b4p", {{"slice", "7"}, {"range", "0.25"}}, 3);
  EXPECT_EQ(value(planner, "slice"), "7");
  EXPECT_EQ(value(planner, "range"), "0.25");
  EXPECT_EQ(value(planner, "threads"), "3");
}

TEST_F(Planners, PaperModeIsAPlannerOfItsOwn) {
  EXPECT_EQ(value(make("b4p", {}), "paper"), "0");
  EXPECT_EQ(value(make("b4p-paper", {}), "paper"), "1");
}

TEST_F(Planners, EveryParameterOfThisPackagesPlannersHasAMeaning) {
  for (const char* name :
       {"b4p", "rrt-individual", "rrt-shared", "rrt-restart", "jplus-rrt", "ik-rrt", "bik-rrt"}) {
    const auto planner = make(name, {});
    for (const auto& entry : planner->params().getParams())
      EXPECT_NE(parameterMeaning(*planner, entry.first), "") << name << ' ' << entry.first;
  }
  EXPECT_EQ(parameterMeaning(*make("rrtconnect", {}), "range"), "");
}

TEST_F(Planners, AreMadeForTasks) {
  EXPECT_EQ(catalogue_.namesFor(TaskKind::kPickPlace),
            "b4p, b4p-paper, rrt-individual, rrt-shared, rrt-restart, redirectable-rrtconnect, rrtconnect");
  EXPECT_EQ(catalogue_.namesFor(TaskKind::kReach),
            "b4p, rrtconnect, jplus-rrt, ik-rrt, bik-rrt, rrt, rrtstar");
}

TEST_F(Planners, RefuseWhatTheyDoNotTake) {
  EXPECT_THROW(make("b5p", {}), InputError);
  EXPECT_THROW(make("b4p", {{"no_such", "1"}}), InputError);
  for (const char* bad : {"0", "-1", "1.5", "many", "3 ", "", "1e99", "nan"})
    EXPECT_THROW(make("b4p", {{"slice", bad}}), InputError) << bad;
  for (const char* name : {"b4p", "b4p-paper"})
    for (const char* own : {"paper", "threads"}) EXPECT_THROW(make(name, {{own, "1"}}), InputError) << own;
  for (const char* bad : {"0", "-1", "inf"})
    EXPECT_THROW(make("rrt-shared", {{"restart_s", bad}}), InputError) << bad;
  for (const char* bad : {"0.5", "11"})
    EXPECT_THROW(make("rrt-restart", {{"growth", bad}}), InputError) << bad;
  EXPECT_THROW(make("rrt-individual", {{"redraw", "2"}}), InputError);
  EXPECT_THROW(make("b4p", {}, 0), InputError);
  EXPECT_THROW(make("rrtconnect", {}, 2), InputError);
  EXPECT_NO_THROW(make("rrtconnect", {{"range", "0.1234567"}}));
}

}  // namespace
}  // namespace b4p::test
