// SPDX-License-Identifier: BSD-3-Clause
// What state and edge checks cost with FCL and with the vectorised checker: a Panda that holds a box among 20
// boxes, and the shipped scenes; self-collision on, edge step 1 cm. items_per_second counts states or edges;
// us_per_sample is the time of an edge over the number of samples at which it is known to be free, whether
// looked at or not.
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "experiments/checker_choice.h"
#include "experiments/problem.h"
#include "state_validity/edge_samples.h"
#include "state_validity/posed_pieces.h"
#include "state_validity/vector_context.h"

namespace b4p {
namespace {

constexpr int kObstacles = 20;
constexpr std::size_t kQueries = 256;
using Configuration = std::vector<double>;

struct Edge {
  Configuration q1;
  Configuration q2;
};

CollisionProblem pandaAmongBoxes() {
  std::mt19937_64 random(1);
  const RobotFile robot = loadRobotFile("panda");
  CollisionProblem problem{std::make_shared<const Manipulator>(loadUrdf(robot.urdf_file), robot.description,
                                                               Eigen::Isometry3d::Identity(), "panda"),
                           {},
                           {{Box{{0.06, 0.06, 0.12}}, Eigen::Isometry3d::Identity()}}};
  std::uniform_real_distribution<> angle(-M_PI, M_PI), distance(0.45, 0.9), height(0.1, 1.0), side(0.03, 0.2);
  for (int i = 0; i < kObstacles; ++i) {
    PlacedShape box{Box{{side(random), side(random), side(random)}}, Eigen::Isometry3d::Identity()};
    const double around = angle(random), away = distance(random);
    box.X_BS.translation() =
        Eigen::Vector3d(away * std::cos(around), away * std::sin(around), height(random));
    problem.obstacles.push_back({"box" + std::to_string(i), box});
  }
  return problem;
}

// One workload for both checkers, drawn with a fixed seed.
class Workload {
 public:
  explicit Workload(const std::string& name) {
    if (name == "boxes") {
      problem_ = pandaAmongBoxes();
      grasp.X_OT = Eigen::Translation3d(0.0, 0.0, 0.04) * Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX());
      grasp.opening_m = 0.062;
    } else {
      const Problem scene = makeProblem(loadScene(name));
      problem_ = scene.checker->problem();
      const auto region = scene.region->makeSceneContext(1);
      Configuration q(static_cast<std::size_t>(problem_.robot->dof()));
      GraspId id = kNoGrasp;
      while (!region->samplePick(q.data(), id)) {
      }
      grasp = scene.region->grasp(id);
    }
    context_ = makeContext(CheckerKind::kFast);
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

  double samplesPerEdge(const std::vector<Edge>& edges) const {
    PosedPieces pieces(std::make_shared<const FclWorld>(problem_));
    pieces.hold(&grasp);
    double count = 0.0;
    for (const Edge& edge : edges)
      count += 1.0 + static_cast<double>(EdgeSamples(edge.q1.data(), edge.q2.data(), problem_.robot->dof(),
                                                     pieces.sweptBound(edge.q1.data(), edge.q2.data()),
                                                     problem_.edge_step_m)
                                             .last());
    return count / static_cast<double>(edges.size());
  }

  std::unique_ptr<CollisionContext> makeContext(CheckerKind kind) const {
    return makeChecker(kind, problem_)->makeContext();
  }

  Grasp grasp;
  std::vector<Configuration> any_states;
  std::vector<Configuration> free_states;

 private:
  Configuration randomState() {
    Configuration q;
    for (int i = 0; i < problem_.robot->dof(); ++i)
      q.push_back(
          std::uniform_real_distribution<>(problem_.robot->lower()[i], problem_.robot->upper()[i])(random_));
    return q;
  }

  std::mt19937_64 random_{1};
  CollisionProblem problem_;
  std::unique_ptr<CollisionContext> context_;
};

void checkStates(benchmark::State& state, const Workload& workload, CheckerKind kind,
                 const std::vector<Configuration>& states) {
  const auto context = workload.makeContext(kind);
  std::size_t i = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(context->isFree(states[i++ % kQueries].data(), &workload.grasp));
  state.SetItemsProcessed(state.iterations());
}

void checkManyStates(benchmark::State& state, const Workload& workload, CheckerKind kind) {
  const auto context = workload.makeContext(kind);
  std::vector<double> all;
  for (const Configuration& q : workload.any_states) all.insert(all.end(), q.begin(), q.end());
  bool free[kQueries];
  for (auto _ : state) {
    context->areFree(all.data(), kQueries, &workload.grasp, free);
    benchmark::DoNotOptimize(free[0]);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kQueries));
}

template <typename Ask>
void checkEdges(benchmark::State& state, const Workload& workload, CheckerKind kind,
                const std::vector<Edge>& edges, double samples, const Ask& ask) {
  const auto context = workload.makeContext(kind);
  std::size_t i = 0;
  for (auto _ : state) {
    const Edge& edge = edges[i++ % kQueries];
    benchmark::DoNotOptimize(ask(*context, edge, &workload.grasp));
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["samples"] = samples;
  const auto per_edge = [&state](std::uint64_t count) {
    return static_cast<double>(count) / static_cast<double>(state.iterations());
  };
  state.counters["looked_at"] = per_edge(context->configurationsChecked());
  if (const auto* vector = dynamic_cast<const VectorContext*>(context.get()))
    state.counters["fcl_pairs"] = per_edge(vector->pairsJudged());
  state.counters["us_per_sample"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * samples * 1e-6,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void registerAll(const std::string& name) {
  const auto workload = std::make_shared<Workload>(name);
  const auto isEdgeFree = [](CollisionContext& context, const Edge& edge, const Grasp* held) {
    return context.isEdgeFree(edge.q1.data(), edge.q2.data(), held);
  };
  const auto freeFraction = [](CollisionContext& context, const Edge& edge, const Grasp* held) {
    return context.freeFraction(edge.q1.data(), edge.q2.data(), held);
  };
  const auto title = [&name](const std::string& what, CheckerKind kind) {
    return name + "/" + what + "/" + checkerName(kind);
  };
  const CheckerKind kinds[] = {CheckerKind::kFcl, CheckerKind::kFast};
  for (const CheckerKind kind : kinds) {
    benchmark::RegisterBenchmark(title("any_state", kind).c_str(), [=](benchmark::State& state) {
      checkStates(state, *workload, kind, workload->any_states);
    });
    benchmark::RegisterBenchmark(title("free_state", kind).c_str(), [=](benchmark::State& state) {
      checkStates(state, *workload, kind, workload->free_states);
    });
    benchmark::RegisterBenchmark(title("many_states", kind).c_str(),
                                 [=](benchmark::State& state) { checkManyStates(state, *workload, kind); });
  }
  // The share of the way to a random state that an edge covers.
  for (const int percent : {10, 50})
    for (const bool free : {true, false}) {
      const std::vector<Edge> edges = workload->edges(free, percent / 100.0);
      const double samples = workload->samplesPerEdge(edges);
      const std::string what = (free ? "free_edge_" : "blocked_edge_") + std::to_string(percent);
      for (const CheckerKind kind : kinds)
        benchmark::RegisterBenchmark(title(what, kind).c_str(), [=](benchmark::State& state) {
          checkEdges(state, *workload, kind, edges, samples, isEdgeFree);
        });
      if (free) continue;
      for (const CheckerKind kind : kinds)
        benchmark::RegisterBenchmark(title("free_fraction_" + std::to_string(percent), kind).c_str(),
                                     [=](benchmark::State& state) {
                                       checkEdges(state, *workload, kind, edges, samples, freeFraction);
                                     });
    }
}

}  // namespace
}  // namespace b4p

int main(int argc, char** argv) {
  for (const char* name : {"boxes", "grocery", "stick", "maze"}) b4p::registerAll(name);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
