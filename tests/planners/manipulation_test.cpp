// SPDX-License-Identifier: BSD-3-Clause
// Promises: the manipulation space keeps OMPL's contract for state spaces and carries the grasp; a motion
// that changes the grasp or starts in collision is invalid; the goal's samples are placements, its failures
// rejected.
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

#include "planners/toy_world.h"

namespace b4p::test {
namespace {

namespace ob = ompl::base;
using StateType = ManipulationStateSpace::StateType;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

DiscWorld openWorld() {
  DiscWorld world;
  world.grasps = eightGrasps();
  return world;
}

class ManipulationSpace : public ::testing::Test {
 protected:
  ob::State* state(double x, double y, GraspId grasp) {
    auto* s = setup.si->allocState()->as<StateType>();
    s->q[0] = x;
    s->q[1] = y;
    s->grasp = grasp;
    states.push_back(s);
    return s;
  }
  ~ManipulationSpace() override {
    for (ob::State* s : states) setup.si->freeState(s);
  }

  DiscProblem setup{openWorld()};
  std::vector<ob::State*> states;
};

TEST_F(ManipulationSpace, KeepsOmplsContract) {
  EXPECT_NO_THROW(
      setup.space->sanityChecks(1e-9, 1e-6, ~0u & ~ob::StateSpace::STATESPACE_ENFORCE_BOUNDS_NO_OP));
}

TEST_F(ManipulationSpace, DifferentGraspsLieFartherApartThanAnyJoints) {
  const double corner_to_corner = setup.space->distance(state(0, 0, 1), state(10, 10, 1));
  EXPECT_GT(setup.space->distance(state(5, 5, 1), state(5, 5, 2)), corner_to_corner);
  setup.space->setGraspDistance(0.0);
  EXPECT_EQ(setup.space->distance(state(5, 5, 1), state(5, 5, 2)), 0.0);
  EXPECT_THROW(setup.space->setGraspDistance(-1.0), ompl::Exception);
  EXPECT_THROW(setup.space->setGraspDistance(kNan), ompl::Exception);
}

TEST_F(ManipulationSpace, EqualStatesHaveEqualGrasps) {
  EXPECT_TRUE(setup.space->equalStates(state(1, 2, 3), state(1, 2, 3)));
  EXPECT_FALSE(setup.space->equalStates(state(1, 2, 3), state(1, 2, 4)));
}

TEST_F(ManipulationSpace, InterpolationKeepsTheGraspAndEndsExactly) {
  ob::State* between = state(0, 0, kNoGrasp);
  setup.space->interpolate(state(1, 2, 3), state(3, 3, 3), 0.5, between);
  EXPECT_TRUE(setup.space->equalStates(between, state(2, 2.5, 3)));
  setup.space->interpolate(state(0.1, 0.2, 3), state(0.3, 0.7, 4), 1.0, between);
  EXPECT_TRUE(setup.space->equalStates(between, state(0.3, 0.7, 4)));
}

TEST_F(ManipulationSpace, BetweenGraspsThereIsNoMotion) {
  ob::State* between = state(0, 0, kNoGrasp);
  setup.space->interpolate(state(1, 2, 3), state(3, 3, 4), 0.9, between);
  EXPECT_TRUE(setup.space->equalStates(between, state(1, 2, 3)));
}

TEST_F(ManipulationSpace, SerialisationCarriesTheGrasp) {
  std::vector<char> bytes(setup.space->getSerializationLength());
  setup.space->serialize(bytes.data(), state(1.25, 7.5, 6));
  ob::State* read = state(0, 0, 0);
  setup.space->deserialize(read, bytes.data());
  EXPECT_TRUE(setup.space->equalStates(read, state(1.25, 7.5, 6)));
}

TEST_F(ManipulationSpace, SamplesKnownGraspsAlone) {
  const auto sampler = setup.space->allocStateSampler();
  ob::State* sampled = state(0, 0, 0);
  std::vector<int> seen(8, 0);
  for (int i = 0; i < 400; ++i) {
    sampler->sampleUniform(sampled);
    ++seen.at(static_cast<std::size_t>(sampled->as<StateType>()->grasp));
    EXPECT_TRUE(setup.space->satisfiesBounds(sampled));
  }
  for (const int count : seen) EXPECT_GT(count, 0);
}

TEST_F(ManipulationSpace, NonFiniteStatesAreInvalid) {
  for (const double bad : {kNan, std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(setup.space->satisfiesBounds(state(bad, 5, 0)));
    EXPECT_FALSE(setup.si->isValid(state(5, bad, 0)));
    EXPECT_FALSE(setup.si->checkMotion(state(5, bad, 0), state(5, 5, 0)));
    EXPECT_FALSE(setup.si->checkMotion(state(5, 5, 0), state(5, bad, 0)));
  }
}

TEST_F(ManipulationSpace, UnknownGraspsAreInvalid) {
  for (const GraspId unknown : {8, 1000, -2}) {
    EXPECT_FALSE(setup.si->isValid(state(5, 5, unknown)));
    EXPECT_FALSE(setup.si->checkMotion(state(5, 5, unknown), state(6, 5, unknown)));
  }
  EXPECT_TRUE(setup.si->isValid(state(5, 5, kNoGrasp)));
}

TEST_F(ManipulationSpace, MotionsDoNotChangeTheGrasp) {
  EXPECT_TRUE(setup.si->checkMotion(state(2, 5, 1), state(3, 5, 1)));
  EXPECT_FALSE(setup.si->checkMotion(state(2, 5, 1), state(3, 5, 2)));
  std::pair<ob::State*, double> last{state(0, 0, 0), 1.0};
  EXPECT_FALSE(setup.si->checkMotion(state(2, 5, 1), state(3, 5, 2), last));
  EXPECT_EQ(last.second, 0.0);
  EXPECT_TRUE(setup.space->equalStates(last.first, state(2, 5, 1)));
}

TEST_F(ManipulationSpace, FirstPointOfAMotionIsChecked) {
  setup.world->walls = {{{1.9, 4.9}, {2.1, 5.1}}};
  EXPECT_FALSE(setup.si->checkMotion(state(2, 5, 1), state(9, 9, 1)));
  std::pair<ob::State*, double> last{state(0, 0, 0), 1.0};
  EXPECT_FALSE(setup.si->checkMotion(state(2, 5, 1), state(9, 9, 1), last));
  EXPECT_EQ(last.second, 0.0);
}

TEST_F(ManipulationSpace, LastValidIsReachedByAValidMotion) {
  setup.world->walls = wallWithOpening(0.0);
  std::pair<ob::State*, double> last{state(0, 0, 0), 0.0};
  EXPECT_FALSE(setup.si->checkMotion(state(2, 5, 1), state(9, 6, 1), last));
  EXPECT_GT(last.second, 0.1);
  EXPECT_LT(last.second, 0.5);
  EXPECT_TRUE(setup.si->checkMotion(state(2, 5, 1), last.first));
}

TEST_F(ManipulationSpace, ManyThreadsGetTheSameVerdicts) {
  setup.world->walls = wallWithOpening(0.9);
  std::vector<ob::State*> ends;
  const auto sampler = setup.space->allocStateSampler();
  for (int i = 0; i < 500; ++i) sampler->sampleUniform(ends.emplace_back(state(0, 0, 0)));
  const auto verdicts = [&] {
    std::vector<bool> free;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      ends[i + 1]->as<StateType>()->grasp = ends[0]->as<StateType>()->grasp;
      free.push_back(setup.si->checkMotion(ends[i], ends[i + 1]));
    }
    return free;
  };
  const auto serial = verdicts();  // also gives all states one grasp, before the threads start
  std::vector<std::vector<bool>> parallel(4);
  std::vector<std::thread> threads;
  for (auto& answer : parallel)
    threads.emplace_back([&answer, &ends, this] {
      for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        answer.push_back(setup.si->checkMotion(ends[i], ends[i + 1]));
    });
  for (std::thread& thread : threads) thread.join();
  for (const auto& answer : parallel) EXPECT_EQ(answer, serial);
}

TEST_F(ManipulationSpace, GoalSamplesArePlacementsOfEveryGrasp) {
  ob::State* sampled = state(0, 0, 0);
  std::vector<int> seen(8, 0);
  for (int i = 0; i < 80; ++i) {
    setup.goal->sampleGoal(sampled);
    ASSERT_TRUE(setup.si->satisfiesBounds(sampled));
    EXPECT_TRUE(setup.goal->isSatisfied(sampled));
    ++seen.at(static_cast<std::size_t>(sampled->as<StateType>()->grasp));
  }
  for (const int count : seen) EXPECT_EQ(count, 10);
}

TEST_F(ManipulationSpace, FailedGoalSamplesAreOutOfBounds) {
  setup.world->walls = {setup.world->region};
  ob::State* sampled = state(5, 5, 0);
  setup.goal->sampleGoal(sampled);
  EXPECT_FALSE(setup.si->satisfiesBounds(sampled));
}

TEST_F(ManipulationSpace, StartAndGoalPairWhenTheirGraspsAreEqual) {
  EXPECT_TRUE(setup.goal->isStartGoalPairValid(state(1, 5, 2), state(9, 5, 2)));
  EXPECT_FALSE(setup.goal->isStartGoalPairValid(state(1, 5, 2), state(9, 5, 3)));
}

TEST(ManipulationSpaceBounds, HaveToBeFiniteAndOrdered) {
  ob::RealVectorBounds reversed(1);
  reversed.setLow(1.0);
  reversed.setHigh(0.0);
  EXPECT_THROW(ManipulationStateSpace{reversed}, ompl::Exception);
  ob::RealVectorBounds endless(1);
  endless.setLow(0.0);
  endless.setHigh(std::numeric_limits<double>::infinity());
  EXPECT_THROW(ManipulationStateSpace{endless}, ompl::Exception);
  EXPECT_THROW(ManipulationStateSpace{ob::RealVectorBounds(0)}, ompl::Exception);
}

}  // namespace
}  // namespace b4p::test
