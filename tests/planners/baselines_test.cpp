// SPDX-License-Identifier: BSD-3-Clause
// Promises of the baselines alone. RRTIndividual: a thread keeps the grasp and the placement it has drawn,
// unless redraw is asked for. RRTShared: all threads grow one pair of trees, and another one after the limit.
// RRTRestart: it finds the one grasp that fits, slices grow, no pair is dropped. All: one thread and one seed
// give one path; progress counts what there is; given picks come first; parameters out of range are named.
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <set>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/ScopedState.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "planners/baselines/rrt_individual.h"
#include "planners/baselines/rrt_restart.h"
#include "planners/baselines/rrt_shared.h"
#include "planners/toy_world.h"

namespace b4p::test {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using StateType = ManipulationStateSpace::StateType;

DiscWorld worldWithOpening(double opening) {
  DiscWorld world;
  world.grasps = eightGrasps();
  world.walls = wallWithOpening(opening);
  return world;
}

/// No grasp but number 3 has a place root: under the others the object is wider than the shaft it is placed
/// in.
DiscWorld onlyGraspThreeCanBePlaced() {
  DiscWorld world = worldWithOpening(0.0);
  world.start = {2.0, 5.0};
  for (int i = 0; i < 8; ++i)
    if (i != 3) world.grasps[static_cast<std::size_t>(i)].object_radius = 0.9;
  world.walls.push_back({{7.7, 0.0}, {8.05, DiscWorld::kSize}});
  world.walls.push_back({{9.75, 0.0}, {DiscWorld::kSize, DiscWorld::kSize}});
  return world;
}

/// A search whose workers the test steps by hand.
template <class PairsSearch, class Parameters>
struct Stepped {
  Stepped(const DiscWorld& world, const Parameters& parameters, unsigned workers, std::uint_fast32_t seed = 1)
      : setup(world) {
    ompl::msg::noOutputHandler();
    ompl::RNG::setSeed(seed);
    inputs.use(setup.problem);
    search = std::make_unique<PairsSearch>(
        SearchProblem{setup.si, setup.goal.get(), setup.region.get(), inputs, statistics}, parameters);
    for (unsigned i = 0; i < workers; ++i) crew.push_back(search->newWorker(seed + i));
    search->resume();
  }

  void step(int times) {
    for (int i = 0; i < times; ++i)
      for (const auto& worker : crew) worker->step();
  }

  DiscProblem setup;
  ob::PlannerInputStates inputs;
  Statistics statistics;
  std::unique_ptr<PairsSearch> search;
  std::vector<std::unique_ptr<ParallelWorker>> crew;
};

using SteppedIndividual = Stepped<IndividualSearch, RRTIndividualParameters>;
using SteppedShared = Stepped<SharedSearch, RRTSharedParameters>;
using SteppedRestart = Stepped<RestartSearch, RRTRestartParameters>;

// ---- RRTIndividual

TEST(RRTIndividualSearch, EachWorkerKeepsItsGraspAndItsPlacement) {
  SteppedIndividual stepped(worldWithOpening(0.0), {}, 4);
  stepped.step(100);
  const auto first = stepped.search->pairs();
  ASSERT_EQ(first.size(), 4u);
  for (const auto& pair : first) EXPECT_TRUE(pair->complete());
  stepped.step(3000);
  EXPECT_EQ(stepped.search->pairs(), first);
  for (const auto& pair : first) {
    int roots = 0;
    pair->forEachNode([&](const Node& node) {
      EXPECT_EQ(node.state->as<StateType>()->grasp, pair->grasp());
      roots += node.parent == nullptr ? 1 : 0;
    });
    EXPECT_EQ(roots, 2);
    EXPECT_GT(pair->nodeCount(), 100u);
  }
  EXPECT_EQ(stepped.statistics.pairs, 4u);
  EXPECT_EQ(stepped.statistics.grasps_taken, 4u);
}

TEST(RRTIndividualSearch, GraspWithoutAPlacementIsKeptUnlessRedrawIsAskedFor) {
  RRTIndividualParameters parameters;
  SteppedIndividual literal(onlyGraspThreeCanBePlaced(), parameters, 8);
  literal.step(2000);
  EXPECT_EQ(literal.statistics.grasps_taken, 8u);
  unsigned complete = 0;
  for (const auto& pair : literal.search->pairs()) {
    EXPECT_EQ(pair->complete(), pair->grasp() == 3);
    complete += pair->complete() ? 1 : 0;
  }
  EXPECT_LT(complete, 8u);
  EXPECT_EQ(literal.statistics.pairs, complete);

  parameters.redraw = true;
  SteppedIndividual redrawing(onlyGraspThreeCanBePlaced(), parameters, 8);
  redrawing.step(2000);
  EXPECT_EQ(redrawing.statistics.pairs, 8u);
  for (const auto& pair : redrawing.search->pairs()) EXPECT_EQ(pair->grasp(), 3);
  EXPECT_GT(redrawing.statistics.grasps_taken, 8u);
}

/// A context of a region without any place root, which counts its placements.
class HopelessContext : public PickPlaceContext {
 public:
  explicit HopelessContext(std::atomic<int>& drawn) : drawn_(drawn) {}
  bool samplePick(double* q, GraspId& grasp) override {
    q[0] = q[1] = 2.0;
    grasp = 0;
    return true;
  }
  PlacementId samplePlacement() override { return drawn_++; }
  bool placeRoot(PlacementId placement, GraspId, double*) override {
    EXPECT_LT(placement, drawn_);
    return false;
  }

 private:
  std::atomic<int>& drawn_;
};

class HopelessRegion : public DiscRegion {
 public:
  using DiscRegion::DiscRegion;
  std::unique_ptr<PickPlaceContext> makeContext(std::uint64_t) const override {
    return std::make_unique<HopelessContext>(drawn);
  }
  mutable std::atomic<int> drawn{0};
};

// A region keeps every placement that is drawn.
TEST(RRTIndividualSearch, GraspWithoutAPlacementDoesNotFillTheMemory) {
  const DiscProblem setup(worldWithOpening(0.0));
  const HopelessRegion region(setup.world);
  ob::PlannerInputStates inputs;
  inputs.use(setup.problem);
  Statistics statistics;
  IndividualSearch search({setup.si, setup.goal.get(), &region, inputs, statistics}, {});
  const auto worker = search.newWorker(1);
  for (int i = 0; i < 300000; ++i) worker->step();
  EXPECT_GT(statistics.placements_tried, 290000u);
  EXPECT_LE(region.drawn, 100000);
}

TEST(RRTIndividualSearch, FirstWorkerWhoseTreesMeetEndsIt) {
  SteppedIndividual stepped(worldWithOpening(3.0), {}, 4);
  stepped.step(20000);
  ASSERT_TRUE(stepped.search->finished());
  EXPECT_EQ(stepped.search->connections().size(), 1u);
}

// ---- RRTShared

TEST(RRTSharedSearch, AllWorkersGrowOnePair) {
  RRTSharedParameters parameters;
  parameters.restart_iterations = 1000000;
  SteppedShared stepped(worldWithOpening(0.0), parameters, 4);
  stepped.step(1000);
  const auto pairs = stepped.search->pairs();
  ASSERT_EQ(pairs.size(), 1u);
  // All steps but those that drew roots.
  EXPECT_GT(pairs[0]->iterations(), 3900u);
  EXPECT_EQ(stepped.statistics.pairs, 1u);
  EXPECT_EQ(stepped.statistics.restarts, 0u);
}

TEST(RRTSharedSearch, RestartsWithAnotherPairAndDropsTheTrees) {
  RRTSharedParameters parameters;
  parameters.restart_iterations = 500;
  SteppedShared stepped(worldWithOpening(0.0), parameters, 2);
  std::set<GraspId> grasps;
  for (int step = 0; step < 10000; ++step) {
    stepped.step(1);
    const auto now = stepped.search->pairs();
    ASSERT_LE(now.size(), 1u);
    if (now.empty()) continue;
    ASSERT_LE(now[0]->iterations(), 500u);
    grasps.insert(now[0]->grasp());
  }
  EXPECT_EQ(stepped.statistics.restarts, 20000u / 500u - 1u);
  EXPECT_EQ(grasps.size(), 8u);
  std::uint64_t nodes = 0;
  stepped.search->forEachNode([&nodes](const Node&) { ++nodes; });
  EXPECT_EQ(stepped.statistics.nodes, nodes);
}

TEST(RRTSharedSearch, RestartsByTheClockOfSolveAlone) {
  RRTSharedParameters parameters;
  parameters.restart_s = 1e-3;
  SteppedShared fast(worldWithOpening(0.0), parameters, 1);
  fast.step(20000);
  EXPECT_GT(fast.statistics.restarts, 1u);

  parameters.restart_s = 0.5;
  SteppedShared paused(worldWithOpening(0.0), parameters, 1);
  paused.step(10);
  paused.search->pause();
  std::this_thread::sleep_for(std::chrono::milliseconds(600));
  paused.search->resume();
  paused.step(10);
  EXPECT_EQ(paused.statistics.restarts, 0u);

  parameters.restart_s = 1e6;
  SteppedShared slow(worldWithOpening(0.0), parameters, 1);
  slow.step(20000);
  EXPECT_EQ(slow.statistics.restarts, 0u);
}

TEST(RRTSharedSearch, GraspWithoutAPlacementIsKeptUntilTheRestartUnlessRedrawIsAskedFor) {
  RRTSharedParameters parameters;
  parameters.restart_iterations = 1000;
  SteppedShared literal(onlyGraspThreeCanBePlaced(), parameters, 1);
  literal.step(20000);
  EXPECT_GE(literal.statistics.grasps_taken, 19u);
  EXPECT_LE(literal.statistics.grasps_taken, 20u);

  parameters.redraw = true;
  SteppedShared redrawing(onlyGraspThreeCanBePlaced(), parameters, 1);
  redrawing.step(20000);
  EXPECT_GT(redrawing.statistics.grasps_taken, 40u);
  EXPECT_GE(redrawing.statistics.pairs, 18u);
}

// A given pick that does not fit has its turn once, the first.
TEST(RRTSharedPlanner, RestartsLeadToTheGraspThatFits) {
  ompl::msg::noOutputHandler();
  const DiscProblem setup(worldWithOpening(0.6));
  ob::ScopedState<ManipulationStateSpace> start(setup.si);
  start->q[0] = start->q[1] = 2.0;
  start->grasp = 5;
  setup.problem->addStartState(start);
  RRTShared planner(setup.si);
  RRTSharedParameters parameters;
  parameters.threads = 2;
  parameters.restart_s = 0.2;
  planner.setParameters(parameters);
  planner.setProblemDefinition(setup.problem);
  EXPECT_EQ(planner.ob::Planner::solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
  const auto& path = *setup.problem->getSolutionPath()->as<og::PathGeometric>();
  EXPECT_EQ(path.getState(0)->as<StateType>()->grasp, 3);
  // The trees and the junction in the planner's data are those of the last attempt.
  ob::PlannerData data(setup.si);
  planner.getPlannerData(data);
  EXPECT_EQ(data.numStartVertices(), 1u);
  EXPECT_EQ(std::stoul(data.properties.at("tree nodes INTEGER")), data.numVertices());
}

// ---- RRTRestart

TEST(RRTRestartSearch, FindsTheOneGraspThatFits) {
  for (std::uint_fast32_t seed = 1; seed <= 5; ++seed) {
    SteppedRestart stepped(worldWithOpening(0.6), {}, 2, seed);
    for (int i = 0; i < 1000000 && !stepped.search->finished(); ++i) stepped.step(1);
    ASSERT_TRUE(stepped.search->finished());
    const auto path = stepped.search->takeSolution();
    EXPECT_EQ(path->getState(0)->as<StateType>()->grasp, 3);
  }
}

TEST(RRTRestartSearch, PairsAreGrownInSlicesThatGrowAndNoneIsDropped) {
  RRTRestartParameters parameters;
  parameters.slice = 10;
  SteppedRestart stepped(worldWithOpening(0.0), parameters, 1);
  std::set<const TreePair*> seen;
  for (int i = 0; i < 300; ++i) {
    stepped.step(20);
    const auto pairs = stepped.search->pairs();
    const std::set<const TreePair*> now = [&pairs] {
      std::set<const TreePair*> all;
      for (const auto& pair : pairs)
        if (pair->complete()) all.insert(pair.get());
      return all;
    }();
    for (const TreePair* pair : seen) EXPECT_EQ(now.count(pair), 1u);
    seen = now;
  }
  // Whole slices of 10, 20, 40, ... each, but for the pair that has its turn just now.
  const auto pairs = stepped.search->pairs();
  ASSERT_GT(pairs.size(), 16u);
  unsigned unfinished = 0;
  for (const auto& pair : pairs) {
    const double slices = std::log2(static_cast<double>(pair->iterations()) / 10.0 + 1.0);
    if (slices != std::floor(slices)) ++unfinished;
  }
  EXPECT_LE(unfinished, 1u);
  EXPECT_GE(pairs.front()->iterations(), 10u * 15u);
  EXPECT_GT(pairs.front()->iterations(), pairs.back()->iterations());
}

class Race : public ::testing::Test {
 protected:
  std::shared_ptr<TreePair> newPair() {
    return std::make_shared<TreePair>(setup.si, start.get(), 0, statistics);
  }
  DiscProblem setup{worldWithOpening(3.0)};
  ob::ScopedState<ManipulationStateSpace> start{setup.si};
  Statistics statistics;
};

TEST_F(Race, EachRoundDoublesPairsAndSlices) {
  SliceRace race(100, 2.0, 5);
  std::map<const TreePair*, std::vector<std::uint64_t>> slices;
  std::map<std::uint64_t, std::uint64_t> joined;
  SliceRace::Turn turn = race.take();
  for (; turn.round < 7; turn = race.take()) {
    if (turn.pair == nullptr) {
      EXPECT_LE(turn.draws, 5u);
      ++joined[turn.round];
      turn.pair = newPair();
    }
    slices[turn.pair.get()].push_back(turn.iterations);
    race.giveBack(turn);
  }
  EXPECT_EQ(joined,
            (std::map<std::uint64_t, std::uint64_t>{{1, 1}, {2, 1}, {3, 2}, {4, 4}, {5, 8}, {6, 16}}));
  std::map<std::size_t, int> pairs_by_slices;
  for (const auto& [pair, given] : slices) {
    ++pairs_by_slices[given.size()];
    for (std::size_t i = 0; i < given.size(); ++i) EXPECT_EQ(given[i], 100u << i);
  }
  EXPECT_EQ(pairs_by_slices, (std::map<std::size_t, int>{{6, 1}, {5, 1}, {4, 2}, {3, 4}, {2, 8}, {1, 16}}));
}

TEST_F(Race, TwoWorkersNeverHaveTheSamePair) {
  SliceRace race(1, 2.0, 5);
  SliceRace::Turn mine = race.take();
  mine.pair = newPair();
  for (int i = 0; i < 100; ++i) {
    SliceRace::Turn other = race.take();
    EXPECT_NE(other.pair, mine.pair);
    if (other.pair == nullptr && i % 10 == 0) other.pair = newPair();
    other.draws = 0;
    race.giveBack(other);
  }
}

TEST_F(Race, DrawingThatFindsNothingLeavesMostOfTheWorkToThePairs) {
  SliceRace race(100, 2.0, 5);
  SliceRace::Turn first = race.take();
  first.pair = newPair();
  race.giveBack(first);
  std::uint64_t draws = 0, iterations = 0, turns_of_the_pair = 0;
  for (int i = 0; turns_of_the_pair < 10 && i < 100000; ++i) {
    SliceRace::Turn turn = race.take();
    if (turn.pair == nullptr) {
      draws += turn.draws;
      turn.draws = 0;
    } else {
      iterations += turn.iterations;
      ++turns_of_the_pair;
    }
    race.giveBack(turn);
  }
  ASSERT_EQ(turns_of_the_pair, 10u);
  EXPECT_GE(draws, 10u * 5u);
  EXPECT_LE(draws, 5u * (iterations / 100u));
}

// ---- all of them

template <class Planner, class Parameters>
std::vector<double> pathWithSeed(std::uint_fast32_t seed, const Parameters& parameters) {
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(seed);
  const DiscProblem setup(worldWithOpening(1.5));
  Planner planner(setup.si);
  planner.setParameters(parameters);
  planner.setProblemDefinition(setup.problem);
  EXPECT_EQ(planner.ob::Planner::solve(30.0), ob::PlannerStatus::EXACT_SOLUTION);
  std::vector<double> values;
  const auto& path = *setup.problem->getSolutionPath()->as<og::PathGeometric>();
  for (unsigned i = 0; i < path.getStateCount(); ++i) {
    const auto* s = path.getState(i)->as<StateType>();
    values.insert(values.end(), {s->q[0], s->q[1], static_cast<double>(s->grasp)});
  }
  return values;
}

template <class Planner, class Parameters>
void expectSameBytes(const Parameters& parameters) {
  const auto once = pathWithSeed<Planner>(11, parameters), again = pathWithSeed<Planner>(11, parameters),
             other = pathWithSeed<Planner>(12, parameters);
  ASSERT_EQ(once.size(), again.size());
  EXPECT_EQ(std::memcmp(once.data(), again.data(), once.size() * sizeof(double)), 0);
  EXPECT_NE(once, other);
}

TEST(Baselines, OneSeedGivesTheSameBytesOnOneThread) {
  expectSameBytes<RRTIndividual>(RRTIndividualParameters{});
  RRTSharedParameters shared;
  shared.restart_iterations = 50;  // several attempts before a path is found
  expectSameBytes<RRTShared>(shared);
  RRTRestartParameters restart;
  restart.slice = 20;
  expectSameBytes<RRTRestart>(restart);
}

template <class Search, class Parameters>
void expectGivenPickFirst() {
  Stepped<Search, Parameters> stepped(worldWithOpening(3.0), {}, 2);
  ob::ScopedState<ManipulationStateSpace> start(stepped.setup.si);
  start->q[0] = start->q[1] = 2.0;
  start->grasp = 5;
  EXPECT_TRUE(stepped.search->addRoot(Side::kPick, start.get(), 5));
  stepped.step(1);
  ASSERT_FALSE(stepped.search->pairs().empty());
  bool found = false;
  stepped.search->pairs().front()->forEachNode(
      [&](const Node& node) { found = found || stepped.setup.si->equalStates(node.state, start.get()); });
  EXPECT_TRUE(found);
}

TEST(Baselines, TakeGivenPicksFirst) {
  expectGivenPickFirst<IndividualSearch, RRTIndividualParameters>();
  expectGivenPickFirst<SharedSearch, RRTSharedParameters>();
  expectGivenPickFirst<RestartSearch, RRTRestartParameters>();
}

// Pairs in the hands of a worker that is not stepped any more would never grow again.
TEST(RRTRestartPlanner, FewerThreadsStarveNoPair) {
  SteppedRestart stepped(worldWithOpening(0.0), {}, 4);
  stepped.step(50);
  const auto pairs = stepped.search->pairs();
  ASSERT_GE(pairs.size(), 4u);
  for (const auto& worker : stepped.crew) worker->rest();
  stepped.crew.resize(1);
  stepped.step(20000);
  for (const auto& pair : pairs) EXPECT_GT(pair->iterations(), 500u);
}

TEST(BaselineParameters, OutOfRangeIsNamed) {
  const auto expectNamed = [](const auto& parameters, const char* name) {
    EXPECT_NE(parameters.problem().find(name), std::string::npos) << name << ": " << parameters.problem();
  };
  EXPECT_EQ(RRTIndividualParameters{}.problem() + RRTSharedParameters{}.problem() +
                RRTRestartParameters{}.problem(),
            "");
  RRTIndividualParameters individual;
  individual.threads = 65;
  expectNamed(individual, "threads");
  individual = {};
  individual.placement_attempts = 0;
  expectNamed(individual, "placement_attempts");
  RRTSharedParameters shared;
  shared.range = -1.0;
  expectNamed(shared, "range");
  for (const double bad : {0.0, -1.0, std::nan(""), 1e7}) {
    shared = {};
    shared.restart_s = bad;
    expectNamed(shared, "restart_s");
  }
  RRTRestartParameters restart;
  restart.slice = 0;
  expectNamed(restart, "slice");
  restart = {};
  restart.root_attempts = 0;
  expectNamed(restart, "root_attempts");
  for (const double bad : {0.9, 11.0, std::nan("")}) {
    restart = {};
    restart.growth = bad;
    expectNamed(restart, "growth");
  }
}

}  // namespace
}  // namespace b4p::test
