// SPDX-License-Identifier: BSD-3-Clause
// What local optimisation promises: the object stays where it can stand, free and level, the objective rises,
// and it ends for the reason it says.
#include <cmath>

#include <gtest/gtest.h>
#include <ompl/util/Console.h>

#include "planners/lever_arm.h"
#include "planners/placement/local_optimiser.h"

namespace b4p::test {
namespace {

namespace ob = ompl::base;

constexpr double kStep = 0.01;

LocalOptimiser::Result improve(const LeverProblem& setup, const ob::ScopedState<>& from,
                               const LocalOptimisation& settings = {}) {
  LocalOptimiser optimiser(setup.si, *setup.goal, settings);
  return optimiser.improve(from.get(), setup.goal->objective(from.get()),
                           ob::plannerNonTerminatingCondition());
}

/// Every state stands on the table and is free, every motion is valid, and the last state has the objective
/// that is claimed, no lower than the first one's.
void expectSound(const LeverProblem& setup, const ob::ScopedState<>& from,
                 const LocalOptimiser::Result& result) {
  const ob::State* before = from.get();
  double value = setup.goal->objective(before);
  for (const ob::ScopedState<>& state : result.states) {
    EXPECT_TRUE(setup.si->checkMotion(before, state.get()));
    EXPECT_TRUE(setup.world->stable(setup.objectAt(state.get())));
    EXPECT_GE(setup.goal->objective(state.get()), value);
    value = setup.goal->objective(state.get());
    before = state.get();
  }
  EXPECT_EQ(value, result.objective);
}

TEST(LocalOptimiser, ClimbsToTheOptimum) {
  const LeverProblem setup(LeverWorld{}, nearTo({0.3, -0.2}));
  for (const GraspId arm : {0, 1}) {
    const auto from = setup.holding(arm, {-0.3, 0.2, 0.0}, 0.4);
    const auto result = improve(setup, from);
    EXPECT_TRUE(result.end == LocalEnd::kFlat || result.end == LocalEnd::kNoGain);
    EXPECT_NEAR(result.objective, 0.0, 1e-4);
    expectSound(setup, from, result);
  }
}

TEST(LocalOptimiser, TurnsTheObjectAsWell) {
  constexpr double kBest_rad = 0.7;
  const LeverProblem setup(LeverWorld{}, [](const Eigen::Isometry3d& X_WO) {
    return std::cos(std::atan2(X_WO.linear()(1, 0), X_WO.linear()(0, 0)) - kBest_rad);
  });
  const auto from = setup.holding(0, {-0.3, 0.2, 0.0}, 0.2);
  const auto result = improve(setup, from);
  EXPECT_NEAR(result.objective, 1.0, 1e-4);
  ASSERT_FALSE(result.states.empty());
  const Eigen::Isometry3d X_WO = setup.objectAt(result.states.back().get());
  EXPECT_NEAR(std::atan2(X_WO.linear()(1, 0), X_WO.linear()(0, 0)), kBest_rad, 0.02);
  EXPECT_NEAR((X_WO.translation().head<2>() - Eigen::Vector2d(-0.3, 0.2)).norm(), 0.0, 0.01)
      << "a turn is about the object's own vertical";
  expectSound(setup, from, result);
}

TEST(LocalOptimiser, HeightAndTiltAreKept) {
  const LeverProblem setup(LeverWorld{}, nearTo({0.8, 0.0}));
  const auto from = setup.holding(0, {0.0, 0.0, 0.0});
  const auto result = improve(setup, from);
  ASSERT_GT(result.states.size(), 40u);
  for (const auto& state : result.states) {
    EXPECT_NEAR(setup.objectAt(state.get()).translation().z(), 0.0, 1e-5);
    EXPECT_LT(LeverWorld::tilt(setup.objectAt(state.get())), 1e-5);
  }
}

TEST(LocalOptimiser, StepsHaveTheLengthAskedFor) {
  const LeverProblem setup(LeverWorld{}, nearTo({0.8, 0.0}));
  const auto from = setup.holding(0, {0.0, 0.0, 0.0});
  for (const double step : {kStep, 0.003}) {
    const auto result = improve(setup, from, {step, 5});
    EXPECT_EQ(result.end, LocalEnd::kSteps);
    ASSERT_EQ(result.states.size(), 5u);
    const ob::State* before = from.get();
    for (const auto& state : result.states) {
      EXPECT_NEAR(setup.space->jointDistance(before, state.get()), step, 0.05 * step);
      before = state.get();
    }
  }
}

TEST(LocalOptimiser, StopsBeforeAnObstacle) {
  LeverWorld world;
  world.blocks.push_back({{0.2, -1.0}, {0.4, 1.0}, 0.3});
  const LeverProblem setup(world, nearTo({0.8, 0.0}));
  const auto from = setup.holding(0, {-0.1, 0.0, 0.0});
  const auto result = improve(setup, from);
  EXPECT_EQ(result.end, LocalEnd::kCollision);
  ASSERT_FALSE(result.states.empty());
  EXPECT_NEAR(setup.objectAt(result.states.back().get()).translation().x(), 0.1, 0.03);
  expectSound(setup, from, result);
}

TEST(LocalOptimiser, StopsAtTheTablesEdge) {
  const LeverProblem setup(LeverWorld{}, nearTo({0.5, 1.2}));
  const auto from = setup.holding(0, {0.5, 0.8, 0.0});
  const auto result = improve(setup, from);
  EXPECT_EQ(result.end, LocalEnd::kLostContact);
  expectSound(setup, from, result);
}

TEST(LocalOptimiser, StopsAtAJointLimit) {
  constexpr double kTurned_rad = 3.15;
  const LeverProblem setup(LeverWorld{}, [](const Eigen::Isometry3d& X_WO) {
    return std::sin(std::atan2(X_WO.linear()(1, 0), X_WO.linear()(0, 0)) - kTurned_rad);
  });
  const auto from = setup.holding(0, {0.0, 0.0, 0.0}, 3.1);
  const auto result = improve(setup, from);
  EXPECT_EQ(result.end, LocalEnd::kJointLimit);
  expectSound(setup, from, result);
}

TEST(LocalOptimiser, StopsWhereTheJacobianLosesRank) {
  LeverWorld world;
  world.stiff = true;
  const LeverProblem setup(world, nearTo({0.3, 0.0}));
  const auto result = improve(setup, setup.holding(0, {0.0, 0.0, 0.0}));
  EXPECT_EQ(result.end, LocalEnd::kSingular);
  EXPECT_TRUE(result.states.empty());
}

TEST(LocalOptimiser, StopsWhereTheObjectiveFalls) {
  const LeverProblem setup(
      LeverWorld{}, [](const Eigen::Isometry3d& X_WO) { return -std::abs(X_WO.translation().y() - 0.303); });
  const auto from = setup.holding(0, {0.0, 0.0, 0.0});
  const auto result = improve(setup, from);
  EXPECT_EQ(result.end, LocalEnd::kNoGain);
  EXPECT_NEAR(result.objective, 0.0, kStep);
  expectSound(setup, from, result);
}

TEST(LocalOptimiser, EndsWhenToldTo) {
  const LeverProblem setup(LeverWorld{}, nearTo({0.8, 0.0}));
  const auto from = setup.holding(0, {0.0, 0.0, 0.0});
  LocalOptimiser optimiser(setup.si, *setup.goal, {});
  int asked = 0;
  const auto result = optimiser.improve(from.get(), setup.goal->objective(from.get()),
                                        ob::PlannerTerminationCondition([&asked] { return ++asked > 7; }));
  EXPECT_EQ(result.end, LocalEnd::kTold);
  EXPECT_EQ(result.states.size(), 7u);
  expectSound(setup, from, result);
}

TEST(LocalOptimiser, FlatObjectiveIsLeftAlone) {
  const LeverProblem setup(LeverWorld{}, [](const Eigen::Isometry3d&) { return 1.0; });
  const auto result = improve(setup, setup.holding(0, {0.0, 0.0, 0.0}));
  EXPECT_EQ(result.end, LocalEnd::kFlat);
  EXPECT_TRUE(result.states.empty());
  EXPECT_EQ(result.objective, 1.0);
}

TEST(LocalOptimiser, StepsThatGainNothingAreLeftOut) {
  // Rises in stairs of 5 cm; the differences that make the gradient see the next stair.
  const LeverProblem setup(LeverWorld{}, [](const Eigen::Isometry3d& X_WO) {
    return std::floor(20.0 * X_WO.translation().y() + 1e-9) / 20.0;
  });
  setup.objective->setSteps(0.1, 0.02);
  const auto from = setup.holding(0, {0.0, 0.0, 0.0});
  const auto result = improve(setup, from, {kStep, 12});
  ASSERT_FALSE(result.states.empty());
  EXPECT_NEAR(result.objective, 0.1, 1e-9);
  expectSound(setup, from, result);
  EXPECT_LE(result.states.size(), 11u) << "the second stair is reached in ten steps or eleven";
}

}  // namespace
}  // namespace b4p::test
