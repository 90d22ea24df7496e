// SPDX-License-Identifier: BSD-3-Clause
// What redirection promises: a goal that has been removed is never reported, what has grown from it is used
// all the same, and whatever is removed and rooted anew, every edge of a tree can be gone in its direction.
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "planners/field.h"
#include "planners/manhattan_space.h"
#include "planners/placement/redirectable_rrt_connect.h"
#include "planners/toy_world.h"

namespace b4p::test {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

using Real = Field::Point;

bool anyPair(const ob::State*, const ob::State*) { return true; }

/// Each node leads to a root of its own side, along motions that are valid in the direction in which they
/// would be gone.
void expectSound(const RedirectableTrees& trees, const ob::SpaceInformationPtr& si) {
  std::size_t nodes = 0;
  trees.forEachNode([&](const Node& node) {
    ++nodes;
    const Node* root = &node;
    std::size_t depth = 0;
    for (; root->parent != nullptr; root = root->parent) ASSERT_LE(++depth, trees.nodeCount()) << "a cycle";
    EXPECT_EQ(root, node.tree->root);
    if (node.parent == nullptr) return;
    EXPECT_EQ(node.parent->tree->side, node.tree->side);
    const bool forward = node.tree->side == Side::kPick;
    EXPECT_TRUE(forward ? si->checkMotion(node.parent->state, node.state)
                        : si->checkMotion(node.state, node.parent->state));
  });
  EXPECT_EQ(nodes, trees.nodeCount());
}

/// A start at (1, 5) with a node at (3, 5), and a backward tree from (6, 5) with nodes (4, 5), (3, 5) and,
/// beside the way, (4, 7).
struct TwoTrees : Field {
  TwoTrees() : trees(si, distance(), kNoGrasp) {
    trees.addStart(at(1, 5).get());
    forward = trees.grow(trees.nearest(Side::kPick, at(1, 5).get()), at(3, 5).get());
    trees.addGoal(7, at(6, 5).get());
    root = trees.goalRoot(7);
    middle = trees.grow(root, at(4, 5).get());
    meeting = trees.grow(middle, at(3, 5).get());
    beside = trees.grow(middle, at(4, 7).get());
  }

  RedirectableTrees trees;
  const Node *forward, *root, *middle, *meeting, *beside;
};

TEST(RedirectableTrees, GoalIsReachedThroughTheTreeThatIsRootedAnew) {
  TwoTrees setup;
  const auto reached = setup.trees.merge({setup.forward, setup.meeting});
  ASSERT_TRUE(reached);
  EXPECT_EQ(reached->id, 7);
  const og::PathGeometric path = pathTo(*reached->node, setup.si);
  ASSERT_EQ(path.getStateCount(), 4u);
  EXPECT_TRUE(Field::isAt(path.getState(0), 1, 5));
  EXPECT_TRUE(Field::isAt(path.getState(1), 3, 5));
  EXPECT_TRUE(Field::isAt(path.getState(2), 4, 5));
  EXPECT_TRUE(Field::isAt(path.getState(3), 6, 5));
}

TEST(RedirectableTrees, EveryNodeJoinsTheForwardTree) {
  TwoTrees setup;
  setup.trees.merge({setup.forward, setup.meeting});
  EXPECT_EQ(setup.trees.nearest(Side::kPick, setup.at(4, 7).get()), setup.beside);
  EXPECT_EQ(setup.trees.nearest(Side::kPick, setup.at(6, 5).get()), setup.root);
  EXPECT_EQ(setup.trees.nearest(Side::kPlace, setup.at(6, 5).get()), nullptr);
  EXPECT_EQ(setup.trees.backwardNodeCount(), 0u);
  expectSound(setup.trees, setup.si);
}

TEST(RedirectableTrees, RemovedGoalIsNotReportedButItsTreeJoins) {
  TwoTrees setup;
  EXPECT_TRUE(setup.trees.removeGoal(7));
  EXPECT_FALSE(setup.trees.removeGoal(7));
  EXPECT_EQ(setup.trees.nearest(Side::kPlace, setup.at(4, 7).get()), setup.beside);
  EXPECT_FALSE(setup.trees.merge({setup.forward, setup.meeting}));
  EXPECT_EQ(setup.trees.nearest(Side::kPick, setup.at(4, 7).get()), setup.beside);
  EXPECT_EQ(pathTo(*setup.beside, setup.si).getStateCount(), 4u);
  expectSound(setup.trees, setup.si);
}

TEST(RedirectableTrees, RemovedGoalThatIsAddedAgainKeepsItsTree) {
  TwoTrees setup;
  setup.trees.removeGoal(7);
  EXPECT_EQ(setup.trees.addGoal(8, setup.at(6, 5).get()), 8);
  EXPECT_EQ(setup.trees.goalRoot(8), setup.root);
  const auto reached = setup.trees.merge({setup.forward, setup.meeting});
  ASSERT_TRUE(reached);
  EXPECT_EQ(reached->id, 8);
}

TEST(RedirectableTrees, EqualGoalsAreOne) {
  TwoTrees setup;
  EXPECT_EQ(setup.trees.addGoal(8, setup.at(6, 5).get()), 7);
  EXPECT_EQ(setup.trees.goals(), std::vector<GoalId>{7});
}

TEST(RedirectableTrees, LargeTreesThatJoinAreFound) {
  Field field;
  RedirectableTrees trees(field.si, field.distance(), kNoGrasp);
  trees.addStart(field.at(1, 5).get());
  const Node* start = trees.nearest(Side::kPick, field.at(1, 5).get());
  trees.addGoal(0, field.at(6, 5).get());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> draw(0.0, 10.0);
  for (int i = 0; i < 3000; ++i) trees.grow(trees.goalRoot(0), field.at(draw(random), draw(random)).get());
  trees.merge({start, trees.goalRoot(0)});
  std::vector<const Node*> all;
  trees.forEachNode([&all](const Node& node) { all.push_back(&node); });
  for (int i = 0; i < 100; ++i) {
    const auto query = field.at(draw(random), draw(random));
    const auto far = [&](const Node* node) { return field.si->distance(node->state, query.get()); };
    const auto* nearest = *std::min_element(all.begin(), all.end(),
                                            [&](const Node* a, const Node* b) { return far(a) < far(b); });
    EXPECT_EQ(trees.nearest(Side::kPick, query.get()), nearest);
  }
}

/// Goals come and go at random while the search runs.
void expectSoundWhileRedirected(const ob::SpaceInformationPtr& si, const ob::State* start, unsigned seed) {
  RedirectStatistics statistics;
  RedirectableSearch search(si, 0.0, 10, anyPair, statistics);
  search.addStart(start);
  const auto sampler = si->allocStateSampler();
  ob::ScopedState<> goal(si);
  std::mt19937 random(seed);
  std::set<GoalId> open, removed;
  std::size_t reached_goals = 0;
  for (int i = 0; i < 1000; ++i) {
    sampler->sampleUniform(goal.get());
    if (i % 7 == 0 && si->isValid(goal.get())) open.insert(search.addGoal(goal.get()));
    if (i % 11 == 0 && !open.empty()) {
      const GoalId id = *std::next(open.begin(), static_cast<long>(random() % open.size()));
      EXPECT_TRUE(search.removeGoal(id));
      open.erase(id);
      removed.insert(id);
    }
    const auto reached = search.step();
    if (!reached) continue;
    ++reached_goals;
    EXPECT_EQ(removed.count(reached->id), 0u);
    EXPECT_EQ(open.erase(reached->id), 1u);
    og::PathGeometric path = pathTo(*reached->node, si);
    EXPECT_TRUE(path.check());
    EXPECT_TRUE(si->equalStates(path.getState(0), start));
  }
  EXPECT_EQ(search.goals(), std::vector<GoalId>(open.begin(), open.end()));
  EXPECT_GT(reached_goals, 10u);
  EXPECT_GT(statistics.merges, reached_goals) << "no removed goal's tree was ever met";
  for (const RedirectableTrees* trees : search.modes()) expectSound(*trees, si);
}

TEST(RedirectableSearch, EdgesStayValidWhateverIsRemoved) {
  Field field;
  field.is_valid = [](double x, double y) {
    return std::abs(std::fmod(x, 2.5) - 1.25) > 0.2 || y > 8.0 || y < 1.0;
  };
  for (const unsigned seed : {1u, 2u, 3u}) expectSoundWhileRedirected(field.si, field.at(0.5, 5).get(), seed);
}

TEST(RedirectableSearch, EdgesStayValidWhereMotionsHaveADirection) {
  ompl::msg::noOutputHandler();
  auto space = std::make_shared<ManhattanSpace>();
  space->setBounds(0.0, 10.0);
  auto si = std::make_shared<ob::SpaceInformation>(space);
  si->setStateValidityChecker([](const ob::State* state) {
    const double* v = state->as<Real>()->values;
    return std::abs(v[0] - 5.0) > 0.3 || std::abs(v[1] - 5.0) < 1.5;
  });
  si->setup();
  ob::ScopedState<> start(si);
  start[0] = 2.0;
  start[1] = 5.0;
  expectSoundWhileRedirected(si, start.get(), 1);
}

TEST(RedirectableSearch, IsIdleWithoutAnOpenGoal) {
  Field field;
  RedirectStatistics statistics;
  RedirectableSearch search(field.si, 0.0, 10, anyPair, statistics);
  EXPECT_TRUE(search.idle());
  search.addStart(field.at(1, 1).get());
  EXPECT_TRUE(search.idle());
  const GoalId goal = search.addGoal(field.at(9, 9).get());
  EXPECT_FALSE(search.idle());
  search.removeGoal(goal);
  EXPECT_TRUE(search.idle());
  EXPECT_FALSE(search.step());
  EXPECT_EQ(statistics.iterations, 0u);
}

TEST(RedirectableSearch, PairThatTheProblemRefusesIsNotReported) {
  Field field;
  RedirectStatistics statistics;
  const auto left_only = [](const ob::State* start, const ob::State*) {
    return start->as<Real>()->values[0] < 5.0;
  };
  RedirectableSearch search(field.si, 0.0, 10, left_only, statistics);
  search.addStart(field.at(9, 1).get());
  search.addGoal(field.at(9, 2).get());
  for (int i = 0; i < 50; ++i) EXPECT_FALSE(search.step());
  search.addStart(field.at(1, 1).get());
  std::optional<ReachedGoal> reached;
  for (int i = 0; i < 1000 && !reached; ++i) reached = search.step();
  ASSERT_TRUE(reached);
  EXPECT_TRUE(Field::isAt(pathTo(*reached->node, field.si).getState(0), 1, 1));
}

/// Two grasps, both with a start left and a goal right of a wall that only grasp 3 can pass.
struct TwoModes {
  TwoModes() : setup(world()) {
    for (const GraspId grasp : {2, 3}) {
      starts.push_back(at(2.0, 2.0, grasp));
      goals.push_back(at(8.0, 2.0, grasp));
    }
  }

  static DiscWorld world() {
    DiscWorld world;
    world.grasps = eightGrasps();
    world.walls = wallWithOpening(0.6);
    return world;
  }

  ob::ScopedState<ManipulationStateSpace> at(double x, double y, GraspId grasp) const {
    ob::ScopedState<ManipulationStateSpace> state(setup.si);
    state->q[0] = x;
    state->q[1] = y;
    state->grasp = grasp;
    return state;
  }

  DiscProblem setup;
  std::vector<ob::ScopedState<ManipulationStateSpace>> starts, goals;
};

TEST(RedirectableModes, EachHasItsSlice) {
  TwoModes modes;
  RedirectStatistics statistics;
  RedirectableSearch search(modes.setup.si, 0.1, 10, anyPair, statistics);
  for (const auto& start : modes.starts) search.addStart(start.get());
  for (const auto& goal : modes.goals) search.addGoal(goal.get());
  const auto grown = [&](std::size_t mode) { return search.modes()[mode]->nodeCount(); };
  const std::size_t roots = grown(0);
  for (int i = 0; i < 10; ++i) search.step();
  EXPECT_GT(grown(0), roots);
  EXPECT_EQ(grown(1), roots);
  const std::size_t first = grown(0);
  for (int i = 0; i < 10; ++i) search.step();
  EXPECT_EQ(grown(0), first);
  EXPECT_GT(grown(1), roots);
  EXPECT_EQ(search.rounds(), 0u);
  search.step();
  EXPECT_EQ(search.rounds(), 1u);
}

TEST(RedirectableModes, PathKeepsItsGrasp) {
  TwoModes modes;
  RedirectStatistics statistics;
  RedirectableSearch search(modes.setup.si, 0.0, 10, anyPair, statistics);
  for (const auto& start : modes.starts) search.addStart(start.get());
  for (const auto& goal : modes.goals) search.addGoal(goal.get());
  std::optional<ReachedGoal> reached;
  for (int i = 0; i < 100000 && !reached; ++i) reached = search.step();
  ASSERT_TRUE(reached);
  og::PathGeometric path = pathTo(*reached->node, modes.setup.si);
  EXPECT_TRUE(path.check());
  for (const ob::State* state : path.getStates())
    EXPECT_EQ(state->as<ManipulationStateSpace::StateType>()->grasp, 3);
}

TEST(RedirectableModes, ModeWithoutAnOpenGoalHasNoTurn) {
  TwoModes modes;
  RedirectStatistics statistics;
  RedirectableSearch search(modes.setup.si, 0.1, 10, anyPair, statistics);
  for (const auto& start : modes.starts) search.addStart(start.get());
  const GoalId impassable = search.addGoal(modes.goals[0].get());
  search.addGoal(modes.goals[1].get());
  search.removeGoal(impassable);
  for (int i = 0; i < 50; ++i) search.step();
  EXPECT_EQ(search.modes()[0]->nodeCount(), 2u);
  EXPECT_GT(search.modes()[1]->nodeCount(), 2u);
}

/// A wall across the field at x = 5 whose opening can be shut.
class Redirect : public ::testing::Test, protected Field {
 protected:
  Redirect() {
    ompl::RNG::setSeed(1);
    is_valid = [this](double x, double y) { return std::abs(x - 5.0) > 0.2 || (open && y > 7.0); };
    problem = std::make_shared<ob::ProblemDefinition>(si);
    problem->addStartState(at(1, 1));
    problem->setGoalState(at(9, 1));
    planner = std::make_shared<RedirectableRRTConnect>(si);
    planner->setProblemDefinition(problem);
    planner->setup();
  }

  ob::PlannerStatus solve(double time_s) { return planner->ob::Planner::solve(time_s); }

  const ob::State* end() const {
    return problem->getSolutions().back().path_->as<og::PathGeometric>()->getStates().back();
  }

  std::set<std::pair<double, double>> vertices(int tag) const {
    ob::PlannerData data(si);
    planner->getPlannerData(data);
    std::set<std::pair<double, double>> found;
    for (unsigned i = 0; i < data.numVertices(); ++i) {
      const double* v = data.getVertex(i).getState()->as<Real>()->values;
      if (data.getVertex(i).getTag() == tag) found.emplace(v[0], v[1]);
    }
    return found;
  }

  bool open = true;
  ob::ProblemDefinitionPtr problem;
  std::shared_ptr<RedirectableRRTConnect> planner;
};

TEST_F(Redirect, GoalsOfTheProblemAndGivenOnesAreListed) {
  const GoalId given = planner->addGoal(at(8, 8).get());
  EXPECT_EQ(planner->goals(), std::vector<GoalId>{given});
  EXPECT_EQ(planner->addGoal(at(8, 8).get()), given);
  EXPECT_EQ(planner->addGoal(at(5, 1).get()), kNoGoal) << "inside the wall";
  EXPECT_EQ(planner->addGoal(at(11, 1).get()), kNoGoal) << "outside the field";
  EXPECT_EQ(planner->addGoal(at(std::nan(""), 1).get()), kNoGoal);
  EXPECT_EQ(solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_EQ(planner->goals().size(), 2u);
  EXPECT_TRUE(planner->removeGoal(given));
  EXPECT_FALSE(planner->removeGoal(given));
  EXPECT_FALSE(planner->removeGoal(1000));
  EXPECT_EQ(planner->goals().size(), 1u);
}

TEST_F(Redirect, EveryGoalIsReachedOnceBeforeAnyIsAgain) {
  std::set<GoalId> wanted{planner->addGoal(at(8, 8).get()), planner->addGoal(at(9, 9).get())};
  std::set<GoalId> reached;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
    reached.insert(planner->reachedGoal());
  }
  EXPECT_EQ(reached.size(), 3u);
  for (const GoalId goal : wanted) EXPECT_EQ(reached.count(goal), 1u);
  EXPECT_EQ(solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_EQ(reached.count(planner->reachedGoal()), 1u);
  EXPECT_EQ(planner->goals().size(), 3u);
}

TEST_F(Redirect, RemovedGoalIsNotReachedButItsTreeIsAWay) {
  open = false;
  EXPECT_EQ(solve(0.1), ob::PlannerStatus::TIMEOUT);
  const auto grown_from_the_goal = vertices(2);
  ASSERT_GT(grown_from_the_goal.size(), 100u);
  ASSERT_EQ(planner->goals().size(), 1u);
  EXPECT_TRUE(planner->removeGoal(planner->goals().front()));
  const GoalId other = planner->addGoal(at(9, 2).get());
  open = true;
  EXPECT_EQ(solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_EQ(planner->reachedGoal(), other);
  EXPECT_TRUE(isAt(end(), 9, 2));
  const auto forward = vertices(1);
  for (const auto& vertex : grown_from_the_goal) EXPECT_EQ(forward.count(vertex), 1u);
}

TEST_F(Redirect, NothingIsLeftToDoOnceAllGoalsAreRemoved) {
  EXPECT_EQ(solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_TRUE(planner->removeGoal(planner->reachedGoal()));
  EXPECT_TRUE(planner->goals().empty());
  EXPECT_EQ(solve(1.0), ob::PlannerStatus::INVALID_GOAL);
  const GoalId next = planner->addGoal(at(8, 8).get());
  EXPECT_EQ(solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_EQ(planner->reachedGoal(), next);
}

TEST_F(Redirect, ClearForgetsGivenGoals) {
  planner->addGoal(at(8, 8).get());
  planner->clear();
  EXPECT_TRUE(planner->goals().empty());
  EXPECT_EQ(planner->reachedGoal(), kNoGoal);
  EXPECT_EQ(solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_TRUE(isAt(end(), 9, 1));
}

TEST_F(Redirect, OneSeedGivesOnePath) {
  const auto run = [this] {
    ompl::RNG::setSeed(7);
    auto fresh = std::make_shared<RedirectableRRTConnect>(si);
    auto same = std::make_shared<ob::ProblemDefinition>(si);
    same->addStartState(at(1, 1));
    same->setGoalState(at(9, 1));
    fresh->setProblemDefinition(same);
    EXPECT_EQ(fresh->ob::Planner::solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
    std::vector<double> values;
    for (const ob::State* state : same->getSolutionPath()->as<og::PathGeometric>()->getStates())
      values.insert(values.end(), state->as<Real>()->values, state->as<Real>()->values + 2);
    return values;
  };
  EXPECT_EQ(run(), run());
}

TEST_F(Redirect, AddGoalNeedsAProblem) {
  RedirectableRRTConnect lost(si);
  EXPECT_THROW(lost.addGoal(at(1, 1).get()), ompl::Exception);
  EXPECT_FALSE(lost.removeGoal(0));
}

}  // namespace
}  // namespace b4p::test
