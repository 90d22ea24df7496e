// SPDX-License-Identifier: BSD-3-Clause
// Promises: no forest starves, however many join; each is served at ages 0, 1, 2, 4, ..., or from 8 on when
// it was put off; the drawing of roots goes on for ever but becomes rarer when nothing comes of it; two
// workers do not hold the same forests while others wait.
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

using Outcome = Schedule::Outcome;

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
    schedule.giveBack(turn, Outcome::kFruitful);
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
    schedule.giveBack(turn, Outcome::kFruitless);
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
    schedule.giveBack(turn, Outcome::kFruitless);
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

TEST_F(Served, ForestsThatWerePutOffWaitForOthers) {
  ForestPair* boxed_in = newForests();
  schedule.add(boxed_in);
  schedule.giveBack(schedule.take(), Outcome::kPutOff);
  for (int others = 1; others <= 32; ++others) {
    ForestPair* next = newForests();
    schedule.add(next);
    bool served = false;
    for (Schedule::Turn turn = schedule.take(); turn.forests != nullptr; turn = schedule.take()) {
      served = served || turn.forests == boxed_in;
      schedule.giveBack(turn, Outcome::kGrown);
    }
    EXPECT_EQ(served, others == 32) << others;
    schedule.giveBack({}, Outcome::kFruitful);
  }
}

TEST_F(Served, IdleWorkersShareWhatIsLent) {
  schedule.add(newForests());
  schedule.take();  // the forests
  const Schedule::Turn drawing = schedule.take();
  EXPECT_EQ(drawing.forests, nullptr);
  schedule.giveBack(drawing, Outcome::kFruitless);
  const Schedule::Turn turn = schedule.take();
  EXPECT_TRUE(turn.shared);
  EXPECT_EQ(turn.forests, forests.front().get());
  schedule.giveBack(turn, Outcome::kFruitless);
  EXPECT_EQ(schedule.take().forests, nullptr);  // what was shared has not become a turn of its own
}

}  // namespace
}  // namespace b4p
