// SPDX-License-Identifier: BSD-3-Clause
#include "planners/parallel_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace b4p {

namespace ob = ompl::base;
namespace og = ompl::geometric;

ParallelSearch::ParallelSearch(const SearchProblem& problem) : problem_(problem), grasps_(problem.si) {}

bool ParallelSearch::plantGoal() {
  const std::lock_guard<std::mutex> lock(inputs_mutex_);
  const ob::State* goal = problem_.inputs.nextGoal();
  return goal != nullptr && addRoot(Side::kPlace, goal, grasps_.get(goal));
}

bool ParallelSearch::rootsMatch(const Junction& junction) const {
  const Tree& pick = *junction.pick->tree;
  const Tree& place = *junction.place->tree;
  return pick.grasp == place.grasp &&
         problem_.goal->isStartGoalPairValid(pick.root->state, place.root->state);
}

void ParallelSearch::publish(const Junction& junction) {
  share(log(), [this, junction] {
    {
      const std::lock_guard<std::mutex> lock(solution_mutex_);
      connections_.push_back(junction);
    }
    finish(pathThrough(junction, si()).path);
  });
}

void ParallelSearch::publish(const og::PathGeometric& path) {
  share(log(), [this, path] { finish(path); });
}

void ParallelSearch::finish(const og::PathGeometric& path) {
  const std::lock_guard<std::mutex> lock(solution_mutex_);
  if (finished_) return;
  solution_ = path;
  finished_.store(true, std::memory_order_release);
}

std::optional<og::PathGeometric> ParallelSearch::takeSolution() {
  const std::lock_guard<std::mutex> lock(solution_mutex_);
  std::optional<og::PathGeometric> solution;
  std::swap(solution, solution_);
  finished_.store(false, std::memory_order_release);
  return solution;
}

std::vector<Junction> ParallelSearch::connections() const {
  const std::lock_guard<std::mutex> lock(solution_mutex_);
  return connections_;
}

void ParallelSearch::forgetConnections() {
  const std::lock_guard<std::mutex> lock(solution_mutex_);
  connections_.clear();
}

bool allFinite(const ob::StateSpace& space, const ob::State* state) {
  std::vector<double> reals;
  space.copyToReals(reals, state);
  return std::all_of(reals.begin(), reals.end(), [](double value) { return std::isfinite(value); });
}

}  // namespace b4p
