// SPDX-License-Identifier: BSD-3-Clause
// Promises of B4P alone: one thread and one seed give one path; a worker's single steps can be taken from
// outside; trees of different grasps are joined and their path repaired; Eq. 3 is not asked twice.
#include <cstring>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "planners/b4p/b4p_planner.h"
#include "planners/b4p/worker.h"
#include "planners/toy_world.h"

namespace b4p::test {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using StateType = ManipulationStateSpace::StateType;

DiscWorld narrowWorld() {
  DiscWorld world;
  world.grasps = eightGrasps();
  world.walls = wallWithOpening(0.6);
  return world;
}

std::vector<double> valuesOf(const og::PathGeometric& path) {
  std::vector<double> values;
  for (unsigned i = 0; i < path.getStateCount(); ++i) {
    const auto* s = path.getState(i)->as<StateType>();
    values.insert(values.end(), {s->q[0], s->q[1], static_cast<double>(s->grasp)});
  }
  return values;
}

std::vector<double> solveWithSeed(std::uint_fast32_t seed, bool paper) {
  ompl::RNG::setSeed(seed);
  DiscWorld world = narrowWorld();
  world.walls = wallWithOpening(1.5);
  const DiscProblem setup(world);
  B4P planner(setup.si);
  B4PParameters parameters;
  parameters.paper = paper;
  planner.setParameters(parameters);
  planner.setProblemDefinition(setup.problem);
  EXPECT_EQ(planner.ob::Planner::solve(30.0), ob::PlannerStatus::EXACT_SOLUTION);
  return valuesOf(*setup.problem->getSolutionPath()->as<og::PathGeometric>());
}

TEST(B4PPlanner, OneSeedGivesTheSameBytesOnOneThread) {
  ompl::msg::noOutputHandler();
  for (const bool paper : {false, true}) {
    const auto once = solveWithSeed(11, paper), again = solveWithSeed(11, paper),
               other = solveWithSeed(12, paper);
    ASSERT_EQ(once.size(), again.size());
    EXPECT_EQ(std::memcmp(once.data(), again.data(), once.size() * sizeof(double)), 0);
    EXPECT_NE(once, other);
  }
}

/// A goal whose samples are mostly invalid; the first ten valid ones lie where no way leads.
class RareGoal : public ob::GoalSampleableRegion {
 public:
  static constexpr double kInvalid = 5.0, kEnclosed = 7.0, kOpen = 1.0;  ///< first coordinates

  using GoalSampleableRegion::GoalSampleableRegion;
  unsigned maxSampleCount() const override { return std::numeric_limits<unsigned>::max(); }
  double distanceGoal(const ob::State*) const override { return 1.0; }
  void sampleGoal(ob::State* state) const override {
    constexpr int kPerValid = 20, kFirstOpen = 10;
    ++drawn_;
    auto* q = state->as<ob::RealVectorStateSpace::StateType>()->values;
    q[1] = 1.0;
    q[0] = drawn_ % kPerValid != 0 ? kInvalid : drawn_ <= kPerValid * kFirstOpen ? kEnclosed : kOpen;
  }

 private:
  mutable int drawn_ = 0;
};

TEST(B4PPlanner, DrawsGoalsOfAPlainProblemAgainAlthoughMostAreInvalid) {
  ompl::msg::noOutputHandler();
  const auto space = std::make_shared<ob::RealVectorStateSpace>(2);
  space->setBounds(-2.0, 8.0);
  const auto si = std::make_shared<ob::SpaceInformation>(space);
  si->setStateValidityChecker([](const ob::State* state) {
    const double x = state->as<ob::RealVectorStateSpace::StateType>()->values[0];
    return x < 2.0 || x > 6.0;
  });
  si->setup();
  auto problem = std::make_shared<ob::ProblemDefinition>(si);
  ob::ScopedState<> start(space);
  start[0] = start[1] = 0.0;
  problem->addStartState(start);
  problem->setGoal(std::make_shared<RareGoal>(si));
  B4P planner(si);
  planner.setProblemDefinition(problem);
  ASSERT_EQ(planner.ob::Planner::solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
  auto& path = *problem->getSolutionPath()->as<og::PathGeometric>();
  EXPECT_EQ(path.getStates().back()->as<ob::RealVectorStateSpace::StateType>()->values[0], RareGoal::kOpen);
}

TEST(B4PPlanner, SaysWhatEndedItInACrash) {
  ompl::msg::noOutputHandler();
  const DiscProblem setup(narrowWorld());
  const auto si = std::make_shared<ob::SpaceInformation>(setup.space);
  si->setStateValidityChecker([](const ob::State*) -> bool { throw std::runtime_error("out of order"); });
  si->setup();
  B4P planner(si);
  auto problem = std::make_shared<ob::ProblemDefinition>(si);
  problem->setGoal(setup.goal);
  planner.setProblemDefinition(problem);
  EXPECT_EQ(planner.ob::Planner::solve(5.0), ob::PlannerStatus::CRASH);
  EXPECT_EQ(planner.lastError(), "out of order");
}

// All workers ask for the first pick root at once.
TEST(B4PPlanner, OneRootAndManyThreads) {
  ompl::msg::noOutputHandler();
  DiscWorld world = narrowWorld();
  world.walls.clear();
  for (int run = 0; run < 200; ++run) {
    const DiscProblem setup(world);
    B4P planner(setup.si);
    B4PParameters parameters;
    parameters.paper = true;
    parameters.threads = 8;
    parameters.pick_roots = parameters.place_roots = 1;
    planner.setParameters(parameters);
    planner.setProblemDefinition(setup.problem);
    EXPECT_EQ(planner.ob::Planner::solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
  }
}

// Two roots of one grasp a side, of which one in eight fits: without restarts nearly every seed would fail.
TEST(B4PPlanner, PaperModeRestartsWithNewRootsWhenAskedTo) {
  ompl::msg::noOutputHandler();
  const auto solve = [](unsigned restart_iterations, double time_s) {
    ompl::RNG::setSeed(3);
    const DiscProblem setup(narrowWorld());
    B4P planner(setup.si);
    B4PParameters parameters;
    parameters.paper = true;
    parameters.pick_roots = parameters.place_roots = 1;
    parameters.restart_iterations = restart_iterations;
    planner.setParameters(parameters);
    planner.setProblemDefinition(setup.problem);
    const ob::PlannerStatus status = planner.ob::Planner::solve(time_s);
    ob::PlannerData data(setup.si);
    planner.getPlannerData(data);
    EXPECT_EQ(data.numStartVertices(), 1u);
    EXPECT_EQ(std::stoul(data.properties.at("tree nodes INTEGER")), data.numVertices());
    EXPECT_EQ(std::stoul(data.properties.at("restarts INTEGER")) > 0, restart_iterations > 0);
    return status;
  };
  EXPECT_EQ(solve(0, 1.0), ob::PlannerStatus::TIMEOUT);
  EXPECT_EQ(solve(5000, 60.0), ob::PlannerStatus::EXACT_SOLUTION);
}

// Forests in the hands of a worker that is not stepped any more would never grow again.
TEST(B4PPlanner, FewerThreadsStarveNoForests) {
  ompl::msg::noOutputHandler();
  DiscWorld world = narrowWorld();
  world.walls = wallWithOpening(0.0);
  const DiscProblem setup(world);
  B4P planner(setup.si);
  planner.setProblemDefinition(setup.problem);
  const auto nodesOfEachGrasp = [&] {
    ob::PlannerData data(setup.si);
    planner.getPlannerData(data);
    std::vector<unsigned> nodes(world.grasps.size(), 0);
    for (unsigned i = 0; i < data.numVertices(); ++i)
      ++nodes.at(static_cast<std::size_t>(data.getVertex(i).getState()->as<StateType>()->grasp));
    return nodes;
  };
  planner.params().setParam("slice", "20");  // short turns: everybody has many, on slow machines too
  planner.params().setParam("threads", "4");
  EXPECT_EQ(planner.ob::Planner::solve(0.3), ob::PlannerStatus::TIMEOUT);
  const auto before = nodesOfEachGrasp();
  planner.params().setParam("threads", "1");
  EXPECT_EQ(planner.ob::Planner::solve(2.0), ob::PlannerStatus::TIMEOUT);
  const auto after = nodesOfEachGrasp();
  for (std::size_t grasp = 0; grasp < after.size(); ++grasp)
    EXPECT_GT(after[grasp], before[grasp] + 20) << grasp;
}

/// A search whose workers the test steps by hand.
struct SteppedSearch {
  explicit SteppedSearch(const DiscWorld& world, const B4PParameters& chosen = {})
      : setup(world), parameters(chosen) {
    inputs.use(setup.problem);
    search = std::make_unique<Search>(
        SearchProblem{setup.si, setup.goal.get(), setup.region.get(), inputs, statistics}, parameters);
  }
  DiscProblem setup;
  B4PParameters parameters;
  ob::PlannerInputStates inputs;
  Statistics statistics;
  std::unique_ptr<Search> search;
};

TEST(B4PWorker, StepsCanBeTakenFromOutside) {
  ompl::msg::noOutputHandler();
  SteppedSearch stepped(narrowWorld());
  const auto first = makeWorker(*stepped.search, 1), second = makeWorker(*stepped.search, 2);
  std::uint64_t steps = 0;
  constexpr std::uint64_t kMany = 2000000;
  while (!stepped.search->finished() && steps < kMany) (steps++ % 2 == 0 ? first : second)->step();
  ASSERT_TRUE(stepped.search->finished());
  EXPECT_EQ(stepped.statistics.iterations, steps);
  const auto path = stepped.search->takeSolution();
  ASSERT_TRUE(path);
  for (unsigned i = 0; i + 1 < path->getStateCount(); ++i)
    EXPECT_TRUE(stepped.setup.si->checkMotion(path->getState(i), path->getState(i + 1)));
}

TEST(B4PWorker, DoesNothingOnceTheSearchHasFinished) {
  ompl::msg::noOutputHandler();
  DiscWorld world = narrowWorld();
  world.walls.clear();
  SteppedSearch stepped(world);
  const auto worker = makeWorker(*stepped.search, 1);
  while (!stepped.search->finished()) worker->step();
  const auto iterations = stepped.statistics.iterations.load();
  worker->step();
  EXPECT_EQ(stepped.statistics.iterations, iterations);
}

TEST(B4PWorker, EveryKnownGraspGetsForestsThatGrow) {
  ompl::msg::noOutputHandler();
  DiscWorld world = narrowWorld();
  world.walls = wallWithOpening(0.0);
  SteppedSearch stepped(world);
  const auto worker = makeWorker(*stepped.search, 1);
  for (int i = 0; i < 50000; ++i) worker->step();
  EXPECT_FALSE(stepped.search->finished());
  for (GraspId grasp = 0; grasp < 8; ++grasp)
    EXPECT_GT(stepped.search->forestsOf(grasp).nodeCount(), 100u) << "grasp " << grasp;
}

struct Totals {
  std::uint64_t repairs_tried = 0, repairs_succeeded = 0;
  std::uint64_t across_grasps = 0;  ///< solutions over a junction of different grasps
};

/// Over twenty seeds with one worker; the search itself is deterministic.
Totals totalsOf(const B4PParameters& parameters, double opening) {
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(1);
  Totals totals;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    DiscWorld world = narrowWorld();
    world.walls = wallWithOpening(opening);
    SteppedSearch stepped(world, parameters);
    const auto worker = makeWorker(*stepped.search, seed);
    constexpr int kMany = 1000000;
    for (int i = 0; i < kMany && !stepped.search->finished(); ++i) worker->step();
    const auto path = stepped.search->takeSolution();
    EXPECT_TRUE(path) << "seed " << seed;
    if (!path) continue;
    EXPECT_TRUE(path->check()) << "seed " << seed;
    totals.repairs_tried += stepped.statistics.repairs_tried;
    totals.repairs_succeeded += stepped.statistics.repairs_succeeded;
    const auto junctions = stepped.search->connections();
    totals.across_grasps += junctions.empty();
    for (const Junction& junction : junctions)
      EXPECT_EQ(junction.pick->tree->grasp, junction.place->tree->grasp);
  }
  return totals;
}

B4PParameters inMode(bool paper) {
  B4PParameters parameters;
  parameters.paper = paper;
  return parameters;
}

constexpr double kPaperOpening = 1.1, kDefaultOpening = 0.56;

TEST(B4PWorker, TreesOfDifferentGraspsAreJoinedAndRepaired) {
  for (const bool paper : {false, true}) {
    const Totals totals = totalsOf(inMode(paper), paper ? kPaperOpening : kDefaultOpening);
    EXPECT_GT(totals.repairs_succeeded, 0u) << paper;
    EXPECT_GT(totals.across_grasps, 0u) << paper;
  }
}

TEST(B4PWorker, WithoutRelaxedOnlyTreesOfEqualGraspsAreJoined) {
  for (const bool paper : {false, true}) {
    B4PParameters parameters = inMode(paper);
    parameters.relaxed = false;
    const Totals totals = totalsOf(parameters, paper ? kPaperOpening : kDefaultOpening);
    EXPECT_EQ(totals.repairs_tried, 0u) << paper;
    EXPECT_EQ(totals.across_grasps, 0u) << paper;
  }
}

// What is free without repair is a solution still.
TEST(B4PWorker, WithoutRepairCollidingPathsAreThrownAway) {
  for (const bool paper : {false, true}) {
    B4PParameters parameters = inMode(paper);
    parameters.repair = false;
    EXPECT_EQ(totalsOf(parameters, paper ? kPaperOpening : kDefaultOpening).repairs_tried, 0u) << paper;
    const double wide = 4.0;
    const Totals in_the_open = totalsOf(parameters, wide);
    EXPECT_EQ(in_the_open.repairs_tried, 0u) << paper;
    if (paper) {
      EXPECT_GT(in_the_open.across_grasps, 0u);
    }
  }
}

}  // namespace
}  // namespace b4p::test
