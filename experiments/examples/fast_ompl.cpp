// SPDX-License-Identifier: BSD-3-Clause
// OMPL's own RRTConnect, unmodified, in the arm's plain joint space: the same queries with FCL and with the
// vectorised checker. Usage: example_fast_ompl [SCENE]
#include <chrono>
#include <iostream>
#include <memory>

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

constexpr int kQueries = 20;
constexpr double kTimeLimit_s = 2.0;

/// Where the arm picks the object up with some grasp, and where it puts it down with the same one.
struct Task {
  b4p::Grasp grasp;
  std::vector<double> pick, place;
};

std::vector<Task> drawTasks(const b4p::Problem& problem) {
  const auto region = problem.region->makeSceneContext(1);
  std::vector<Task> tasks;
  while (tasks.size() < kQueries) {
    Task task;
    task.pick.resize(static_cast<std::size_t>(problem.robot->dof()));
    task.place = task.pick;
    b4p::GraspId grasp = b4p::kNoGrasp;
    if (!region->samplePick(task.pick.data(), grasp)) continue;
    if (!region->placeRoot(region->samplePlacement(), grasp, task.place.data())) continue;
    task.grasp = problem.region->grasp(grasp);
    tasks.push_back(task);
  }
  return tasks;
}

bool solve(const Task& task, const std::shared_ptr<const b4p::CollisionChecker>& checker) {
  og::SimpleSetup setup(b4p::makeArmSpaceInformation(checker, task.grasp));
  ob::ScopedState<> start(setup.getStateSpace()), goal(setup.getStateSpace());
  start = task.pick;
  goal = task.place;
  setup.setStartAndGoalStates(start, goal);
  setup.setPlanner(std::make_shared<og::RRTConnect>(setup.getSpaceInformation()));
  return setup.solve(kTimeLimit_s) == ob::PlannerStatus::EXACT_SOLUTION;
}

}  // namespace

int main(int argc, char** argv) try {
  ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
  const b4p::Problem problem = b4p::makeProblem(b4p::loadScene(argc > 1 ? argv[1] : "grocery"));
  const std::vector<Task> tasks = drawTasks(problem);
  for (const b4p::CheckerKind kind : {b4p::CheckerKind::kFcl, b4p::CheckerKind::kFast}) {
    const auto checker = makeChecker(kind, problem.checker->problem());
    int solved = 0;
    const auto start = std::chrono::steady_clock::now();
    for (const Task& task : tasks) solved += solve(task, checker);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    std::cout << checker->description() << ": " << solved << " of " << tasks.size() << " solved within "
              << kTimeLimit_s << " s each, " << elapsed.count() << " s in all\n";
    if (solved == 0) return 1;
  }
  return 0;
} catch (const b4p::InputError& e) {
  std::cerr << e.what() << std::endl;
  return 2;
}
