// SPDX-License-Identifier: BSD-3-Clause
// What a state check and an edge check cost: a Panda that holds a box among 20 boxes, self-collision on, edge
// step 1 cm. items_per_second counts states or edges.
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>

#include "experiments/scene.h"
#include "state_validity/collision_checker.h"

namespace b4p {
namespace {

constexpr int kObstacles = 20;
constexpr std::size_t kQueries = 512;
using Configuration = std::array<double, 7>;

struct Edge {
  Configuration q1;
  Configuration q2;
};

// One workload for all benchmarks, drawn with a fixed seed.
class Workload {
 public:
  Workload() : checker_(makeFclChecker(problem())), context_(checker_->makeContext()) {
    grasp.X_OT = Eigen::Translation3d(0.0, 0.0, 0.04) * Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX());
    grasp.opening_m = 0.062;
    while (any_states.size() < kQueries) any_states.push_back(randomState());
    while (free_states.size() < kQueries) {
      const Configuration q = randomState();
      if (context_->isFree(q.data(), &grasp)) free_states.push_back(q);
    }
  }

  // Edges between random free states, shortened to a fraction, all free or all blocked.
  std::vector<Edge> edges(bool free, double fraction) {
    std::vector<Edge> found;
    while (found.size() < kQueries) {
      Edge edge{free_states[random_() % kQueries], randomState()};
      for (std::size_t j = 0; j < edge.q1.size(); ++j)
        edge.q2[j] = edge.q1[j] + fraction * (edge.q2[j] - edge.q1[j]);
      if (context_->isEdgeFree(edge.q1.data(), edge.q2.data(), &grasp) == free) found.push_back(edge);
    }
    return found;
  }

  std::unique_ptr<CollisionContext> makeContext() const { return checker_->makeContext(); }

  Grasp grasp;
  std::vector<Configuration> any_states;
  std::vector<Configuration> free_states;

 private:
  CollisionProblem problem() {
    const RobotFile robot = loadRobotFile("panda");
    robot_ = std::make_shared<const Manipulator>(loadUrdf(robot.urdf_file), robot.description,
                                                 Eigen::Isometry3d::Identity(), "panda");
    CollisionProblem problem{robot_, {}, {{Box{{0.06, 0.06, 0.12}}, Eigen::Isometry3d::Identity()}}};
    std::uniform_real_distribution<> angle(-M_PI, M_PI), distance(0.45, 0.9), height(0.1, 1.0),
        side(0.03, 0.2);
    for (int i = 0; i < kObstacles; ++i) {
      PlacedShape box{Box{{side(random_), side(random_), side(random_)}}, Eigen::Isometry3d::Identity()};
      const double around = angle(random_), away = distance(random_);
      box.X_BS.translation() =
          Eigen::Vector3d(away * std::cos(around), away * std::sin(around), height(random_));
      problem.obstacles.push_back({"box" + std::to_string(i), box});
    }
    return problem;
  }

  Configuration randomState() {
    Configuration q;
    for (int i = 0; i < robot_->dof(); ++i)
      q[static_cast<std::size_t>(i)] =
          std::uniform_real_distribution<>(robot_->lower()[i], robot_->upper()[i])(random_);
    return q;
  }

  std::mt19937_64 random_{1};
  std::shared_ptr<const Manipulator> robot_;
  std::shared_ptr<const CollisionChecker> checker_;
  std::unique_ptr<CollisionContext> context_;
};

Workload& workload() {
  static Workload instance;
  return instance;
}

void checkStates(benchmark::State& state, const std::vector<Configuration>& states) {
  const auto context = workload().makeContext();
  std::size_t i = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(context->isFree(states[i++ % kQueries].data(), &workload().grasp));
  state.SetItemsProcessed(state.iterations());
}

void anyStates(benchmark::State& state) { checkStates(state, workload().any_states); }
void freeStates(benchmark::State& state) { checkStates(state, workload().free_states); }

// The argument is the share, in percent, of the way to a random state that an edge covers.
void checkEdges(benchmark::State& state, bool free) {
  const auto context = workload().makeContext();
  const std::vector<Edge> edges = workload().edges(free, static_cast<double>(state.range(0)) / 100.0);
  std::size_t i = 0;
  for (auto _ : state) {
    const Edge& edge = edges[i++ % kQueries];
    benchmark::DoNotOptimize(context->isEdgeFree(edge.q1.data(), edge.q2.data(), &workload().grasp));
  }
  state.SetItemsProcessed(state.iterations());
}

void freeEdges(benchmark::State& state) { checkEdges(state, true); }
void blockedEdges(benchmark::State& state) { checkEdges(state, false); }

void blockedFreeFraction(benchmark::State& state) {
  const auto context = workload().makeContext();
  const std::vector<Edge> edges = workload().edges(false, static_cast<double>(state.range(0)) / 100.0);
  std::size_t i = 0;
  for (auto _ : state) {
    const Edge& edge = edges[i++ % kQueries];
    benchmark::DoNotOptimize(context->freeFraction(edge.q1.data(), edge.q2.data(), &workload().grasp));
  }
  state.SetItemsProcessed(state.iterations());
}

BENCHMARK(anyStates);
BENCHMARK(freeStates);
BENCHMARK(freeEdges)->Arg(10)->Arg(50);
BENCHMARK(blockedEdges)->Arg(10)->Arg(50);
BENCHMARK(blockedFreeFraction)->Arg(10)->Arg(50);

}  // namespace
}  // namespace b4p

BENCHMARK_MAIN();
