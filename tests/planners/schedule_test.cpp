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

// Turns that are nobody's: of those of ten forests that are not yet due, a quarter goes to the pair whose
// sides are nearest to each other, an eighth to the second, and none goes short.
TEST_F(Served, SidesThatAreNearEachOtherHaveMoreTurns) {
  constexpr int kForests = 10, kTurns = 20000;
  for (int i = 0; i < kForests; ++i) schedule.add(newForests());
  std::map<ForestPair*, int> turns;
  for (int i = 0; i < kTurns; ++i) {
    Schedule::Turn turn = schedule.take();
    if (turn.forests == forests[7].get()) turn.gap = 0.1;
    if (turn.forests == forests[3].get()) turn.gap = 0.2;
    ++turns[turn.forests];
    schedule.giveBack(turn, Outcome::kFruitless);
  }
  const double equal = 0.5 * kTurns / kForests;
  EXPECT_NEAR(turns[forests[7].get()], equal + 0.25 * kTurns, 0.02 * kTurns);
  EXPECT_NEAR(turns[forests[3].get()], equal + 0.125 * kTurns, 0.02 * kTurns);
  for (const auto& pair : forests) EXPECT_GT(turns[pair.get()], 0.9 * equal);
}

TEST_F(Served, ForestsThatAreDueComeBeforeThoseWhoseSidesAreNear) {
  for (int i = 0; i < 3; ++i) schedule.add(newForests());
  for (int i = 0; i < 1000; ++i) {
    Schedule::Turn turn = schedule.take();
    turn.gap = 0.1;
    schedule.giveBack(turn, Outcome::kGrown);
  }
  for (int i = 0; i < 20; ++i) {
    schedule.add(newForests());
    const Schedule::Turn turn = schedule.take();
    EXPECT_EQ(turn.forests, forests.back().get()) << i;
    schedule.giveBack(turn, Outcome::kPutOff);
  }
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
