// SPDX-License-Identifier: BSD-3-Clause
// Promises: no forest starves, however many join; each is served at ages 0, 1, 2, 4, ...; the drawing of roots goes on
// for ever but becomes rarer when nothing comes of it; two workers do not hold the same forests while others wait.
#include <map>
#include <memory>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "planners/b4p/schedule.h"

namespace b4p {
namespace {

class Served : public ::testing::Test {
 protected:
  ForestPair* newForests() {
    forests.push_back(std::make_unique<ForestPair>(si, [](const auto*, const auto*) { return 0.0; }, kNoGrasp));
    return forests.back().get();
  }
  ompl::base::SpaceInformationPtr si =
      std::make_shared<ompl::base::SpaceInformation>(std::make_shared<ompl::base::RealVectorStateSpace>(1));
  std::vector<std::unique_ptr<ForestPair>> forests;
  Schedule schedule;
};

TEST_F(Served, DrawsRootsFirst) { EXPECT_EQ(schedule.take().forests, nullptr); }

TEST_F(Served, EveryForestAgainAndAgainWhileNewOnesKeepComing) {
  std::map<ForestPair*, int> turns;
  for (int i = 0; i < 2000; ++i) {
    const Schedule::Turn turn = schedule.take();
    if (turn.forests == nullptr)
      schedule.add(newForests());
    else
      ++turns[turn.forests];
    schedule.giveBack(turn, true);
  }
  ASSERT_GT(forests.size(), 50u);
  // All but those that came last have had several turns, the oldest the most.
  for (std::size_t i = 0; i < forests.size() / 2; ++i) EXPECT_GE(turns[forests[i].get()], 3) << i;
  EXPECT_GE(turns[forests[0].get()], turns[forests[forests.size() / 2].get()]);
}

TEST_F(Served, FruitlessDrawingBecomesRarerButNeverStops) {
  schedule.add(newForests());
  int draws = 0, late_draws = 0;
  constexpr int kTurns = 4000;
  for (int i = 0; i < kTurns; ++i) {
    const Schedule::Turn turn = schedule.take();
    if (turn.forests == nullptr) {
      ++draws;
      if (i > kTurns / 2) ++late_draws;
    }
    schedule.giveBack(turn, false);
  }
  EXPECT_GT(late_draws, 0);
}

TEST_F(Served, ForestsAreLentOnceWhileOthersWait) {
  for (int i = 0; i < 4; ++i) schedule.add(newForests());
  std::set<ForestPair*> lent;
  for (int i = 0; i < 5; ++i) lent.insert(schedule.take().forests);  // four forests and the drawing of roots
  EXPECT_EQ(lent.size(), 5u);
}

TEST_F(Served, IdleWorkersShareWhatIsLent) {
  schedule.add(newForests());
  schedule.take();
  schedule.take();
  const Schedule::Turn turn = schedule.take();
  EXPECT_TRUE(turn.shared);
  EXPECT_EQ(turn.forests, forests.front().get());
  schedule.giveBack(turn, false);  // adds no turn that was not there
  EXPECT_TRUE(schedule.take().shared);
}

}  // namespace
}  // namespace b4p
