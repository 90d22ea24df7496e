// SPDX-License-Identifier: BSD-3-Clause
// OMPL's own RRTConnect, unmodified, in the arm's plain joint space: the same queries with FCL and with the
// vectorised checker. Usage: example_fast_ompl [SCENE]
#include <chrono>
#include <iostream>
#include <memory>
#include <random>
#include <vector>

#include <ompl/base/ScopedState.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>

#include "experiments/arm_validity.h"
#include "experiments/problem.h"
#include "robots/input_error.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

constexpr int kQueries = 50;
constexpr double kTimeLimit_s = 2.0;

struct Motion {
  std::vector<double> from, to;
};

/// A grasp with which the arm can pick the scene's object up.
b4p::Grasp drawGrasp(const b4p::Problem& problem) {
  const auto region = problem.region->makeSceneContext(1);
  std::vector<double> q(static_cast<std::size_t>(problem.robot->dof()));
  b4p::GraspId id = b4p::kNoGrasp;
  while (!region->samplePick(q.data(), id)) {
  }
  return problem.region->grasp(id);
}

/// Between configurations that are uniform among the free ones.
std::vector<Motion> drawMotions(const b4p::Problem& problem, const b4p::Grasp& grasp) {
  const auto collisions = problem.checker->makeContext();
  std::mt19937_64 random(1);
  const auto draw = [&] {
    std::vector<double> q(static_cast<std::size_t>(problem.robot->dof()));
    do {
      for (std::size_t i = 0; i < q.size(); ++i) {
        const auto joint = static_cast<Eigen::Index>(i);
        q[i] = std::uniform_real_distribution<>(problem.robot->lower()[joint],
                                                problem.robot->upper()[joint])(random);
      }
    } while (!collisions->isFree(q.data(), &grasp));
    return q;
  };
  std::vector<Motion> motions;
  for (int i = 0; i < kQueries; ++i) {
    Motion& motion = motions.emplace_back();
    motion.from = draw();
    motion.to = draw();
  }
  return motions;
}

bool solve(const Motion& motion, const b4p::Grasp& grasp,
           const std::shared_ptr<const b4p::CollisionChecker>& checker) {
  og::SimpleSetup setup(b4p::makeArmSpaceInformation(checker, grasp));
  ob::ScopedState<> start(setup.getStateSpace()), goal(setup.getStateSpace());
  start = motion.from;
  goal = motion.to;
  setup.setStartAndGoalStates(start, goal);
  setup.setPlanner(std::make_shared<og::RRTConnect>(setup.getSpaceInformation()));
  return setup.solve(kTimeLimit_s) == ob::PlannerStatus::EXACT_SOLUTION;
}

}  // namespace

int main(int argc, char** argv) try {
  ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
  const b4p::Problem problem = b4p::makeProblem(b4p::loadScene(argc > 1 ? argv[1] : "grocery"));
  const b4p::Grasp grasp = drawGrasp(problem);
  const std::vector<Motion> motions = drawMotions(problem, grasp);
  for (const b4p::CheckerKind kind : {b4p::CheckerKind::kFcl, b4p::CheckerKind::kFast}) {
    const auto checker = makeChecker(kind, problem.checker->problem());
    int solved = 0;
    const auto start = std::chrono::steady_clock::now();
    for (const Motion& motion : motions) solved += solve(motion, grasp, checker);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    std::cout << checker->description() << ": " << solved << " of " << motions.size() << " solved within "
              << kTimeLimit_s << " s each, " << elapsed.count() << " s in all\n";
    if (solved == 0) return 1;
  }
  return 0;
} catch (const b4p::InputError& e) {
  std::cerr << e.what() << std::endl;
  return 2;
}
