// SPDX-License-Identifier: BSD-3-Clause
// Promises of B4P's parts: every node that joins a forest is found, exactly once, whatever threads do; a path
// through a junction runs from root to root and ends in them exactly; failed pairs are retried once they have
// doubled; a crew ends as a whole when one job throws; parameters out of range are named.
#include <atomic>
#include <cstring>
#include <random>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "planners/b4p/connection_memory.h"
#include "planners/b4p/crew.h"
#include "planners/b4p/forest.h"
#include "planners/b4p/growth.h"
#include "planners/b4p/motion.h"
#include "planners/b4p/parameters.h"

namespace b4p {
namespace {

namespace ob = ompl::base;

class Forests : public ::testing::Test {
 protected:
  Forests() {
    auto space = std::make_shared<ob::RealVectorStateSpace>(2);
    space->setBounds(0.0, 10.0);
    si = std::make_shared<ob::SpaceInformation>(space);
    si->setStateValidityChecker([this](const ob::State* s) { return valid(s); });
    si->setStateValidityCheckingResolution(0.001);
    si->setup();
    forests = std::make_unique<ForestPair>(si, GraspAccess(si).distance(), kNoGrasp);
  }
  ~Forests() override {
    for (ob::State* s : states) si->freeState(s);
  }

  ob::State* state(double x, double y) {
    ob::State* s = si->allocState();
    s->as<ob::RealVectorStateSpace::StateType>()->values[0] = x;
    s->as<ob::RealVectorStateSpace::StateType>()->values[1] = y;
    states.push_back(s);
    return s;
  }
  static double x(const ob::State* s) { return s->as<ob::RealVectorStateSpace::StateType>()->values[0]; }
  bool valid(const ob::State* s) const { return x(s) < wall_begin || x(s) > wall_end; }

  double wall_begin = 20.0, wall_end = 20.0;
  ob::SpaceInformationPtr si;
  std::unique_ptr<ForestPair> forests;
  std::vector<ob::State*> states;
};

TEST_F(Forests, ConcurrentNodesAreEachThereOnce) {
  constexpr int kThreads = 4, kEach = 500;
  const Tree* tree = forests->plant(Side::kPick, state(0, 0), kNoGrasp, kNoPlacement);
  std::vector<ob::State*> added;
  for (int i = 0; i < kThreads * kEach; ++i) added.push_back(state(0.001 * i, 1.0));
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t)
    threads.emplace_back([&, t] {
      for (int i = 0; i < kEach; ++i) {
        ob::State* mine = added[static_cast<std::size_t>(t * kEach + i)];
        forests->grow(forests->nearest(Side::kPick, mine), mine);
      }
    });
  for (std::thread& thread : threads) thread.join();

  EXPECT_EQ(forests->nodeCount(), 1u + kThreads * kEach);
  EXPECT_EQ(tree->size, 1u + kThreads * kEach);
  std::multiset<double> seen;
  forests->forEachNode([&](const Node& node) { seen.insert(x(node.state)); });
  for (const ob::State* s : added) {
    EXPECT_EQ(seen.count(x(s)), x(s) == 0.0 ? 2u : 1u);
    EXPECT_TRUE(si->equalStates(forests->nearest(Side::kPick, s)->state, s));
  }
}

TEST_F(Forests, NearestIsNearestOverAllTreesOfTheSide) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(0.0, 10.0);
  std::vector<ob::State*> roots;
  for (int i = 0; i < 200; ++i) {
    roots.push_back(state(anywhere(random), anywhere(random)));
    forests->plant(i % 2 == 0 ? Side::kPick : Side::kPlace, roots.back(), kNoGrasp, kNoPlacement);
  }
  for (int query = 0; query < 200; ++query) {
    const ob::State* at = state(anywhere(random), anywhere(random));
    double best = 1e9;
    for (std::size_t i = 0; i < roots.size(); i += 2) best = std::min(best, si->distance(roots[i], at));
    EXPECT_EQ(si->distance(forests->nearest(Side::kPick, at)->state, at), best);
  }
}

TEST_F(Forests, EqualRootsOfOneGraspArePlantedOnce) {
  EXPECT_NE(forests->plant(Side::kPick, state(1, 1), 4, kNoPlacement), nullptr);
  EXPECT_EQ(forests->plant(Side::kPick, state(1, 1), 4, kNoPlacement), nullptr);
  EXPECT_NE(forests->plant(Side::kPick, state(1, 1), 5, kNoPlacement), nullptr);
  EXPECT_NE(forests->plant(Side::kPlace, state(1, 1), 4, kNoPlacement), nullptr);
  EXPECT_EQ(forests->treeCount(Side::kPick), 2u);
}

TEST_F(Forests, EmptySideHasNoNearest) { EXPECT_EQ(forests->nearest(Side::kPlace, state(1, 1)), nullptr); }

TEST_F(Forests, PathRunsFromRootToRoot) {
  const Node* pick = forests->plant(Side::kPick, state(1, 1), kNoGrasp, kNoPlacement)->root;
  const Node* place = forests->plant(Side::kPlace, state(4, 1), kNoGrasp, kNoPlacement)->root;
  pick = forests->grow(pick, state(2, 1));
  place = forests->grow(place, state(3, 1));
  const auto [path, junction] = pathThrough({pick, place}, si);
  ASSERT_EQ(path.getStateCount(), 4u);
  EXPECT_EQ(junction, 1u);
  for (unsigned i = 0; i < 4; ++i) EXPECT_EQ(x(path.getState(i)), i + 1.0);
}

TEST_F(Forests, PathEndsInThePlaceRootBitForBit) {
  const double almost_three = std::nextafter(3.0, 4.0);
  const Node* pick = forests->plant(Side::kPick, state(1, 1), kNoGrasp, kNoPlacement)->root;
  const Node* place = forests->plant(Side::kPlace, state(almost_three, 1), kNoGrasp, kNoPlacement)->root;
  const auto path = pathThrough({forests->grow(pick, state(3, 1)), place}, si).path;
  EXPECT_EQ(path.getStateCount(), 2u);
  EXPECT_EQ(x(path.getState(1)), almost_three);
}

TEST_F(Forests, PathBetweenEqualRootsHasBoth) {
  const Node* pick = forests->plant(Side::kPick, state(1, 1), kNoGrasp, kNoPlacement)->root;
  const Node* place = forests->plant(Side::kPlace, state(1, 1), kNoGrasp, kNoPlacement)->root;
  EXPECT_EQ(pathThrough({pick, place}, si).path.getStateCount(), 2u);
}

TEST_F(Forests, ExpansionGoesAsFarAsTheMotionIsFree) {
  wall_begin = 5.0;
  wall_end = 6.0;
  Motion motion(si, 0.0);
  forests->plant(Side::kPick, state(1, 1), kNoGrasp, kNoPlacement);
  const Expansion there = expand(*forests, Side::kPick, state(9, 1), motion);
  ASSERT_NE(there.node, nullptr);
  EXPECT_TRUE(there.added);
  EXPECT_FALSE(there.reached);
  EXPECT_GT(x(there.node->state), 4.9);
  EXPECT_LT(x(there.node->state), 5.0);
  EXPECT_EQ(expand(*forests, Side::kPick, state(9, 1), motion).node, nullptr);  // it cannot move any farther
  EXPECT_EQ(forests->nodeCount(), 2u);
}

TEST_F(Forests, ExpansionToANodeAddsNone) {
  Motion motion(si, 0.0);
  const Node* root = forests->plant(Side::kPick, state(1, 1), kNoGrasp, kNoPlacement)->root;
  const Expansion there = expand(*forests, Side::kPick, state(1, 1), motion);
  EXPECT_EQ(there.node, root);
  EXPECT_TRUE(there.reached);
  EXPECT_FALSE(there.added);
  EXPECT_EQ(forests->nodeCount(), 1u);
}

TEST_F(Forests, JunctionIsFoundInAPathThatLeavesOutRepeatedStates) {
  const Node* pick = forests->plant(Side::kPick, state(1, 1), kNoGrasp, kNoPlacement)->root;
  const Node* place = forests->plant(Side::kPlace, state(4, 1), kNoGrasp, kNoPlacement)->root;
  pick = forests->grow(forests->grow(pick, state(1, 1)), state(2, 1));
  const auto [path, junction] = pathThrough({pick, place}, si);
  EXPECT_EQ(path.getStateCount(), 3u);
  EXPECT_EQ(junction, 1u);
}

TEST_F(Forests, RangeBoundsAnExpansion) {
  Motion motion(si, 0.5);
  EXPECT_EQ(motion.extend(state(1, 1), state(9, 1), kNoGrasp, Side::kPick), Motion::Reach::kAdvanced);
  EXPECT_NEAR(x(motion.end()), 1.5, 1e-12);
  EXPECT_EQ(motion.extend(state(1, 1), state(1.4, 1), kNoGrasp, Side::kPick), Motion::Reach::kReached);
}

TEST_F(Forests, GrowthTowardEachOtherMeets) {
  Motion motion(si, 0.0);
  forests->plant(Side::kPick, state(1, 1), kNoGrasp, kNoPlacement);
  forests->plant(Side::kPlace, state(9, 9), kNoGrasp, kNoPlacement);
  const Growth growth = growAndConnect(*forests, Side::kPlace, state(1, 9), motion);
  ASSERT_TRUE(growth.junction);
  EXPECT_EQ(growth.nodes, 2u);
  EXPECT_EQ(growth.junction->pick->tree->side, Side::kPick);
  EXPECT_TRUE(si->equalStates(growth.junction->pick->state, growth.junction->place->state));
}

TEST_F(Forests, FailedPairsMayBeJoinedAgainOnceTheyHaveDoubled) {
  const Tree* pick = forests->plant(Side::kPick, state(1, 1), 0, kNoPlacement);
  const Tree* place = forests->plant(Side::kPlace, state(9, 9), 1, 0);
  ConnectionMemory memory;
  EXPECT_TRUE(memory.mayJoin(pick, place));
  memory.repairFailed(pick, place);
  EXPECT_FALSE(memory.mayJoin(pick, place));
  forests->grow(pick->root, state(2, 1));
  EXPECT_FALSE(memory.mayJoin(pick, place));
  forests->grow(pick->root, state(3, 1));
  EXPECT_TRUE(memory.mayJoin(pick, place));
}

TEST_F(Forests, AnswersOfEquation3AreRemembered) {
  const Tree* tree = forests->plant(Side::kPlace, state(9, 9), 1, 7);
  ConnectionMemory memory;
  EXPECT_FALSE(memory.placeTree(7, 1));
  memory.setPlaceTree(7, 1, tree);
  memory.setPlaceTree(7, 2, nullptr);
  memory.setPlaceTree(7, 1, nullptr);  // another worker found the root planted already
  EXPECT_EQ(*memory.placeTree(7, 1), tree);
  EXPECT_EQ(*memory.placeTree(7, 2), nullptr);
  EXPECT_FALSE(memory.placeTree(8, 1));
}

TEST(Crew, EveryJobRunsOnce) {
  for (const std::size_t size : {1u, 2u, 8u}) {
    std::vector<std::atomic<int>> calls(size);
    runCrew(size, [&](std::size_t number, const std::atomic<bool>&) { ++calls[number]; });
    for (const auto& count : calls) EXPECT_EQ(count, 1);
  }
}

TEST(Crew, EndsAsAWholeWhenOneJobThrows) {
  for (const std::size_t size : {1u, 2u, 8u})
    EXPECT_THROW(runCrew(size,
                         [size](std::size_t number, const std::atomic<bool>& stop) {
                           if (number == size - 1) throw std::runtime_error("job");
                           while (!stop) std::this_thread::yield();
                         }),
                 std::runtime_error);
}

TEST(Parameters, OutOfRangeIsNamed) {
  const auto problemOf = [](auto change) {
    B4PParameters parameters;
    change(parameters);
    return parameters.problem();
  };
  EXPECT_EQ(problemOf([](B4PParameters&) {}), "");
  EXPECT_NE(problemOf([](B4PParameters& p) { p.threads = 0; }).find("threads"), std::string::npos);
  EXPECT_NE(problemOf([](B4PParameters& p) { p.threads = 65; }).find("65"), std::string::npos);
  EXPECT_NE(problemOf([](B4PParameters& p) { p.pick_roots = 0; }).find("pick_roots"), std::string::npos);
  EXPECT_NE(problemOf([](B4PParameters& p) { p.place_roots = 0; }).find("place_roots"), std::string::npos);
  EXPECT_NE(problemOf([](B4PParameters& p) { p.range = -1.0; }).find("range"), std::string::npos);
  EXPECT_NE(problemOf([](B4PParameters& p) { p.range = std::nan(""); }).find("range"), std::string::npos);
  EXPECT_NE(problemOf([](B4PParameters& p) { p.slice = 0; }).find("slice"), std::string::npos);
  EXPECT_NE(problemOf([](B4PParameters& p) { p.root_attempts = 0; }).find("root_attempts"),
            std::string::npos);
  EXPECT_NE(problemOf([](B4PParameters& p) { p.repair_iterations = 0; }).find("repair"), std::string::npos);
}

}  // namespace
}  // namespace b4p
