// SPDX-License-Identifier: BSD-3-Clause
// Promises: no forest starves, however many join; each is served at ages 0, 1, 2, 4, ...; the drawing of
// roots goes on for ever but becomes rarer when nothing comes of it; two workers do not hold the same forests
// while others wait.
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
    forests.push_back(std::make_unique<ForestPair>(
        si, [](const auto*, const auto*) { return 0.0; }, kNoGrasp));
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

TEST_F(Served, FewForestsEquallyOftenForEver) {
  for (int i = 0; i < 5; ++i) schedule.add(newForests());
  std::map<ForestPair*, int> turns;
  constexpr int kTurns = 20000;
  for (int i = 0; i < kTurns; ++i) {
    const Schedule::Turn turn = schedule.take();
    ++turns[turn.forests];
    schedule.giveBack(turn, false);
  }
  for (const auto& pair : forests) EXPECT_NEAR(turns[pair.get()], kTurns / 5, kTurns / 50);
}

TEST_F(Served, FruitlessDrawingBecomesRarerButNeverStops) {
  schedule.add(newForests());
  int late_draws = 0;
  constexpr int kTurns = 4000;
  for (int i = 0; i < kTurns; ++i) {
    const Schedule::Turn turn = schedule.take();
    if (turn.forests == nullptr && i > kTurns / 2) ++late_draws;
    schedule.giveBack(turn, false);
  }
  EXPECT_GT(late_draws, 0);
  EXPECT_LT(late_draws, kTurns / 20);
}

TEST_F(Served, ForestsAreLentOnceWhileOthersWait) {
  for (int i = 0; i < 4; ++i) schedule.add(newForests());
  std::set<ForestPair*> lent;
  for (int i = 0; i < 4; ++i) lent.insert(schedule.take().forests);
  EXPECT_EQ(lent.size(), 4u);
  EXPECT_EQ(lent.count(nullptr), 0u);
}

TEST_F(Served, IdleWorkersShareWhatIsLent) {
  schedule.add(newForests());
  schedule.take();  // the forests
  const Schedule::Turn drawing = schedule.take();
  EXPECT_EQ(drawing.forests, nullptr);
  schedule.giveBack(drawing, false);
  const Schedule::Turn turn = schedule.take();
  EXPECT_TRUE(turn.shared);
  EXPECT_EQ(turn.forests, forests.front().get());
  schedule.giveBack(turn, false);
  EXPECT_EQ(schedule.take().forests, nullptr);  // what was shared has not become a turn of its own
}

}  // namespace
}  // namespace b4p
