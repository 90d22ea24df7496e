// SPDX-License-Identifier: BSD-3-Clause
// Promises of workers in logical time: a step sees what had been finished when it began, and nothing else but
// its own doing: nodes, roots, repairs, answers of Eq. 3, the solution; of two solutions the one finished
// first counts; N workers take no less than an Nth of their work and no more than all of it; one worker makes
// the path of the planner in a thread; costs alone decide what happens.
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "planners/b4p/search.h"
#include "planners/b4p/virtual_time_b4p.h"
#include "planners/toy_world.h"

namespace b4p::test {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using StateType = ManipulationStateSpace::StateType;

bool never() { return false; }
constexpr double kForEver = 1e9;

/// Narrow enough that both modes join trees of different grasps and repair.
DiscWorld narrowWorld(bool paper = false) {
  DiscWorld world;
  world.grasps = eightGrasps();
  world.walls = wallWithOpening(paper ? 1.1 : 0.6);
  return world;
}

/// Workers whose steps the test writes, over the forests of a real search.
class Steps : public ::testing::Test {
 protected:
  Steps() {
    ompl::msg::noOutputHandler();
    inputs.use(setup.problem);
  }
  ~Steps() override {
    for (ob::State* s : states) setup.si->freeState(s);
  }

  ob::State* state(double x, double y) {
    ob::State* s = setup.si->allocState();
    s->as<StateType>()->q[0] = x;
    s->as<StateType>()->q[1] = y;
    s->as<StateType>()->grasp = 0;
    states.push_back(s);
    return s;
  }

  og::PathGeometric path(double x) {
    og::PathGeometric path(setup.si);
    path.append(state(x, 1.0));
    path.append(state(x, 2.0));
    return path;
  }

  /// A step says what it costs; sharing costs nothing.
  VirtualTime workers(std::size_t count) {
    return VirtualTime(count, log, [this](const std::function<void()>& work) {
      cost = 0.0;
      work();
      return std::exchange(cost, 0.0);
    });
  }

  DiscProblem setup{narrowWorld()};
  B4PParameters parameters;
  ob::PlannerInputStates inputs;
  Statistics statistics;
  PublicationLog log;
  Search search{{setup.si, setup.goal.get(), setup.region.get(), inputs, statistics, &log}, parameters};
  double cost = 0.0;
  std::vector<ob::State*> states;
};

TEST_F(Steps, SeeNodesAndRootsFromTheTimeOnAtWhichTheyWereFinished) {
  ForestPair& forests = search.forestsOf(0);
  const Tree* first = forests.plant(Side::kPick, state(1, 1), 0, kNoPlacement);
  const Node* grown = nullptr;
  std::vector<bool> node_seen, node_seen_anywhere, root_seen, count_seen;
  bool seen_by_itself = false;
  auto time = workers(2);
  time.run(
      [&](std::size_t number) {
        if (number == 0) {
          cost = 10.0;
          if (grown != nullptr) return;
          grown = forests.grow(first->root, state(5, 5));
          search.plant(Side::kPlace, state(9, 9), 0, 7);
          seen_by_itself = forests.nearest(Side::kPick, state(5, 5)) == grown &&
                           search.nearestAnywhere(Side::kPick, state(5, 5)) == grown;
        } else {
          cost = 5.0;
          node_seen.push_back(forests.nearest(Side::kPick, state(5, 5)) == grown);
          node_seen_anywhere.push_back(search.nearestAnywhere(Side::kPick, state(5, 5)) == grown);
          root_seen.push_back(forests.treeCount(Side::kPlace) == 1 &&
                              forests.nearest(Side::kPlace, state(0, 0)) != nullptr);
          count_seen.push_back(search.rootCount(Side::kPlace) == 1 && search.rootsOffered(Side::kPlace) == 1);
        }
      },
      never, never, 20.0);
  const std::vector<bool> at_0_5_10_15{false, false, true, true};
  EXPECT_TRUE(seen_by_itself);
  EXPECT_EQ(node_seen, at_0_5_10_15);
  EXPECT_EQ(node_seen_anywhere, at_0_5_10_15);
  EXPECT_EQ(root_seen, at_0_5_10_15);
  EXPECT_EQ(count_seen, at_0_5_10_15);
}

TEST_F(Steps, SeeRepairsAndTurnsFromTheTimeOnAtWhichTheyWereFinished) {
  const Tree* pick = search.plant(Side::kPick, state(1, 1), 0);
  const Tree* place = search.plant(Side::kPlace, state(9, 9), 0, 7);
  while (search.schedule().take().forests != nullptr) {
  }
  std::vector<bool> repair_seen, turn_seen;
  bool done = false;
  auto time = workers(2);
  time.run(
      [&](std::size_t number) {
        if (number == 0) {
          cost = 10.0;
          if (std::exchange(done, true)) return;
          Motion motion(setup.si, 0.0);
          search.submit(std::make_shared<PathRepair>(setup.si, path(1.0), Junction{pick->root, place->root},
                                                     0, 5, motion, &log));
          search.plant(Side::kPick, state(2, 2), 1);
          search.plant(Side::kPlace, state(8, 8), 1, 7);
        } else {
          cost = 5.0;
          repair_seen.push_back(search.repair() != nullptr && search.repairCount() == 1);
          const auto turn = search.schedule().take();
          turn_seen.push_back(turn.forests == &search.forestsOf(1) && !turn.shared);
        }
      },
      never, never, 12.0);
  EXPECT_EQ(repair_seen, (std::vector<bool>{false, false, true}));
  EXPECT_EQ(turn_seen, (std::vector<bool>{false, false, true}));
}

// Worker 0 mends the run in a step of 10 s that begins first, worker 1 in one of 4 s that begins later.
TEST_F(Steps, ARunIsMendedByWhoFinishesFirst) {
  const Tree* pick = search.plant(Side::kPick, state(1, 5), 0);
  const Tree* place = search.plant(Side::kPlace, state(9, 9), 0, 7);
  setup.world->walls = {{{3.0, 1.3}, {3.2, 1.6}}};
  Motion motion(setup.si, 0.0);
  og::PathGeometric colliding(setup.si);
  colliding.append(state(2.4, 1.5));
  colliding.append(state(4.0, 1.5));
  const auto repair = std::make_shared<PathRepair>(setup.si, colliding, Junction{pick->root, place->root}, 0,
                                                   100000u, motion, &log);
  ASSERT_EQ(repair->runCount(), 1u);
  std::vector<PathRepair::Status> before;
  std::vector<std::size_t> enders;
  auto time = workers(2);
  time.run(
      [&](std::size_t number) {
        before.push_back(repair->status());
        std::optional<PathRepair::Attempt> attempt;
        do attempt = repair->replan(motion);
        while (attempt && !attempt->junction);
        cost = number == 0 ? 10.0 : 4.0;
        if (!attempt) return;
        share(&log, [&, number, found = *attempt] {
          const bool running = repair->status() == PathRepair::Status::kRunning;
          if (repair->accept(found) == PathRepair::Status::kSucceeded && running) enders.push_back(number);
        });
      },
      never, never, 5.0);
  using Status = PathRepair::Status;
  EXPECT_EQ(before, (std::vector<Status>{Status::kRunning, Status::kRunning, Status::kSucceeded}));
  EXPECT_EQ(enders, std::vector<std::size_t>{1});
}

TEST_F(Steps, TheSolutionThatIsFinishedFirstCounts) {
  const std::vector<double> costs{10.0, 3.0};  // worker 0: 0 to 10; worker 1: 0 to 3, 3 to 6, 6 to 9
  int steps_of_1 = 0;
  auto time = workers(2);
  const auto report = time.run(
      [&](std::size_t number) {
        cost = costs[number];
        if (number == 0) search.publish(path(1.0));
        if (number == 1 && ++steps_of_1 == 3) search.publish(path(2.0));
        EXPECT_FALSE(search.finished());
      },
      [this] { return search.finished(); }, never, kForEver);
  EXPECT_TRUE(report.finished);
  EXPECT_EQ(report.time_s, 9.0);
  EXPECT_EQ(report.steps, 3u);
  EXPECT_EQ(report.work_s, 9.0);  // worker 0 had not finished its step
  EXPECT_EQ(search.takeSolution()->getState(0)->as<StateType>()->q[0], 2.0);
}

TEST_F(Steps, OneOfThemThatThrowsEndsThemAllAndLosesItsEffects) {
  auto time = workers(3);
  EXPECT_THROW(time.run(
                   [&](std::size_t number) {
                     cost = 1.0;
                     search.plant(Side::kPick, state(1.0 + static_cast<double>(number), 1), 0);
                     if (number == 1) throw std::runtime_error("out of order");
                   },
                   never, never, kForEver),
               std::runtime_error);
  EXPECT_FALSE(log.recording());
  EXPECT_EQ(search.rootCount(Side::kPick), 0u);
  search.plant(Side::kPick, state(8, 8), 0);  // outside of a step all is seen at once
  EXPECT_EQ(search.rootCount(Side::kPick), 1u);
}

TEST_F(Steps, EqualRootsOfStepsThatOverlapJoinOnce) {
  ForestPair& forests = search.forestsOf(0);
  auto time = workers(4);
  time.run(
      [&](std::size_t) {
        cost = 1.0;
        forests.plant(Side::kPick, state(1, 1), 0, kNoPlacement);
      },
      never, never, 3.0);
  EXPECT_EQ(forests.treeCount(Side::kPick), 1u);
}

TEST(ThreadCost, CountsWorkAndNotWaiting) {
  volatile double sum = 0.0;
  const double idle_s = threadCost([] {});
  const double busy_s = threadCost([&] {
    for (int i = 0; i < 3000000; ++i) sum = sum + std::sqrt(static_cast<double>(i));
  });
  EXPECT_GE(idle_s, 0.0);
  EXPECT_GT(busy_s, idle_s);
}

struct Outcome {
  VirtualTime::Report report;
  std::vector<double> path;
};

double constantCost(const std::function<void()>& work) {
  work();
  return 1.0;
}

std::vector<double> pathOf(const DiscProblem& setup) {
  std::vector<double> values;
  const auto& path = *setup.problem->getSolutionPath()->as<og::PathGeometric>();
  for (unsigned i = 0; i < path.getStateCount(); ++i) {
    const auto* s = path.getState(i)->as<StateType>();
    values.insert(values.end(), {s->q[0], s->q[1], static_cast<double>(s->grasp)});
    if (i == 0) continue;
    EXPECT_TRUE(setup.si->checkMotion(path.getState(i - 1), path.getState(i)));
  }
  return values;
}

std::vector<double> solveWith(B4P& planner, const DiscProblem& setup, unsigned workers, bool paper) {
  B4PParameters parameters;
  parameters.threads = workers;
  parameters.paper = paper;
  planner.setParameters(parameters);
  planner.setProblemDefinition(setup.problem);
  EXPECT_EQ(planner.solve(ob::plannerNonTerminatingCondition()), ob::PlannerStatus::EXACT_SOLUTION);
  return pathOf(setup);
}

Outcome simulate(std::uint_fast32_t seed, unsigned workers, bool paper = false,
                 const CostClock& cost = constantCost) {
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(seed);
  const DiscProblem setup(narrowWorld(paper));
  VirtualTimeB4P planner(setup.si, kForEver, cost);
  const auto path = solveWith(planner, setup, workers, paper);
  return {planner.report(), path};
}

TEST(VirtualTimeOfB4P, OneWorkerMakesThePathOfThePlanner) {
  for (const bool paper : {false, true}) {
    for (std::uint_fast32_t seed = 1; seed <= 10; ++seed) {
      const Outcome simulated = simulate(seed, 1, paper);
      ompl::RNG::setSeed(seed);
      const DiscProblem setup(narrowWorld(paper));
      B4P planner(setup.si);
      EXPECT_EQ(simulated.path, solveWith(planner, setup, 1, paper))
          << "seed " << seed << ", paper " << paper;
      EXPECT_EQ(simulated.report.time_s, simulated.report.work_s);
    }
  }
}

TEST(VirtualTimeOfB4P, TimeLiesBetweenWorkAndItsShare) {
  for (const bool paper : {false, true}) {
    for (const unsigned workers : {1u, 2u, 7u, 64u}) {
      const VirtualTime::Report report = simulate(3, workers, paper, threadCost).report;
      EXPECT_TRUE(report.finished);
      EXPECT_GT(report.steps, 0u);
      constexpr double kRounding = 1e-9;
      EXPECT_GE(report.time_s * (1.0 + kRounding), report.work_s / workers);
      EXPECT_LE(report.time_s, report.work_s * (1.0 + kRounding));
    }
  }
}

TEST(VirtualTimeOfB4P, ConstantCostsMakeItDeterministic) {
  for (const bool paper : {false, true}) {
    const Outcome once = simulate(5, 8, paper), again = simulate(5, 8, paper), other = simulate(6, 8, paper);
    EXPECT_EQ(once.path, again.path);
    EXPECT_EQ(once.report.time_s, again.report.time_s);
    EXPECT_EQ(once.report.work_s, again.report.work_s);
    EXPECT_EQ(once.report.steps, again.report.steps);
    EXPECT_NE(once.path, other.path);
  }
}

TEST(VirtualTimeOfB4P, EightWorkersAreFasterThanOne) {
  double one_s = 0.0, eight_s = 0.0;
  for (std::uint_fast32_t seed = 1; seed <= 20; ++seed) {
    one_s += simulate(seed, 1).report.time_s;
    eight_s += simulate(seed, 8).report.time_s;
  }
  EXPECT_GT(one_s, 2.0 * eight_s);
}

TEST(VirtualTimeOfB4P, EndsAtItsLimitAndGoesOnFromThere) {
  ompl::msg::noOutputHandler();
  DiscWorld world = narrowWorld();
  world.walls = wallWithOpening(0.0);
  const DiscProblem setup(world);
  VirtualTimeB4P planner(setup.si, 1000.0, constantCost);
  planner.params().setParam("threads", "4");
  planner.setProblemDefinition(setup.problem);
  std::size_t nodes = 0;
  for (int solve = 0; solve < 3; ++solve) {
    EXPECT_EQ(planner.solve(ob::plannerNonTerminatingCondition()), ob::PlannerStatus::TIMEOUT);
    EXPECT_FALSE(planner.report().finished);
    EXPECT_EQ(planner.report().time_s, 1000.0);
    EXPECT_EQ(planner.report().work_s, 4000.0);
    EXPECT_EQ(planner.report().steps, 2000u);  // a step and the sharing of its effects cost one second each
    ob::PlannerData data(setup.si);
    planner.getPlannerData(data);
    EXPECT_GT(data.numVertices(), nodes);
    nodes = data.numVertices();
  }
}

TEST(VirtualTimeOfB4P, ExceptionsEndInACrash) {
  ompl::msg::noOutputHandler();
  const DiscProblem setup(narrowWorld());
  const auto si = std::make_shared<ob::SpaceInformation>(setup.space);
  si->setStateValidityChecker([](const ob::State*) -> bool { throw std::runtime_error("out of order"); });
  si->setup();
  VirtualTimeB4P planner(si, kForEver, constantCost);
  auto problem = std::make_shared<ob::ProblemDefinition>(si);
  problem->setGoal(setup.goal);
  planner.setProblemDefinition(problem);
  EXPECT_EQ(planner.solve(ob::plannerNonTerminatingCondition()), ob::PlannerStatus::CRASH);
  EXPECT_EQ(planner.lastError(), "out of order");
}

}  // namespace
}  // namespace b4p::test
