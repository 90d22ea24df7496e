// SPDX-License-Identifier: BSD-3-Clause
// What inverse kinematics cost on the Panda: TCP within 0.1 mm and 1 mrad, answers inside the limits.
//   attempt     one attempt from a random seed at a pose of a random configuration. p: share of attempts that
//               give an answer; valid_per_second: answers a second of CPU time.
//   solve/K     up to K attempts, at random poses that some posture reaches. recall: share of them solved;
//               items_per_second: poses a second.
//   solveAll    all answers for one random value of joint 7 (analytic only).
#include <cmath>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>

#include "experiments/scene.h"
#include "robots/panda_inverse_kinematics.h"

namespace b4p {
namespace {

constexpr std::size_t kPoses = 1000;
constexpr int kExhaustive = 2000;  // values of joint 7 that decide whether a pose can be reached

using Maker = std::unique_ptr<InverseKinematics> (*)(std::shared_ptr<const Manipulator>, IkTolerance);

// One workload for all benchmarks, drawn with a fixed seed.
struct Workload {
  Workload() {
    const RobotFile file = loadRobotFile("panda");
    robot = std::make_shared<const Manipulator>(loadUrdf(file.urdf_file), file.description,
                                                Eigen::Isometry3d::Identity(), "panda");
    std::mt19937_64 random(1);
    Eigen::VectorXd q(robot->dof());
    while (of_configurations.size() < kPoses) {
      for (int i = 0; i < robot->dof(); ++i)
        q[i] = std::uniform_real_distribution<>(robot->lower()[i], robot->upper()[i])(random);
      of_configurations.push_back(robot->tcpPose(q.data()));
    }
    const auto ik = makePandaInverseKinematics(robot);
    std::uniform_real_distribution<> side(-0.8, 0.8), height(-0.3, 1.1);
    std::normal_distribution<> normal;
    for (std::size_t i = 0; i < kPoses; ++i) {
      const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
      const Eigen::Quaterniond R = Eigen::Quaterniond(w, x, y, z).normalized();
      const double forward = side(random), left = side(random), up = height(random);
      const Eigen::Isometry3d X_WT = Eigen::Translation3d(forward, left, up) * R;
      if (ik->solve(X_WT, random, kExhaustive, q)) reachable.push_back(X_WT);
    }
  }

  std::shared_ptr<const Manipulator> robot;
  std::vector<Eigen::Isometry3d> of_configurations;
  std::vector<Eigen::Isometry3d> reachable;  // among kPoses random positions and orientations
};

const Workload& workload() {
  static const Workload instance;
  return instance;
}

/// Asks for every pose in turn, and reports how often there was an answer.
void ask(benchmark::State& state, Maker make, const std::vector<Eigen::Isometry3d>& poses, int attempts,
         const char* share) {
  const auto ik = make(workload().robot, {});
  std::mt19937_64 random(2);
  Eigen::VectorXd q;
  std::size_t i = 0;
  std::int64_t found = 0;
  for (auto _ : state)
    if (ik->solve(poses[i++ % poses.size()], random, attempts, q)) ++found;
  state.SetItemsProcessed(state.iterations());
  state.counters[share] = static_cast<double>(found) / static_cast<double>(state.iterations());
  state.counters["valid_per_second"] =
      benchmark::Counter(static_cast<double>(found), benchmark::Counter::kIsRate);
}

void attempt(benchmark::State& state, Maker make) { ask(state, make, workload().of_configurations, 1, "p"); }

void solve(benchmark::State& state, Maker make) {
  ask(state, make, workload().reachable, static_cast<int>(state.range(0)), "recall");
  state.counters["reachable"] = static_cast<double>(workload().reachable.size());
}

void solveAll(benchmark::State& state) {
  const auto ik = makePandaInverseKinematics(workload().robot);
  const double lower = workload().robot->lower()[6], upper = workload().robot->upper()[6];
  std::mt19937_64 random(2);
  std::vector<Eigen::VectorXd> answers;
  std::size_t i = 0, found = 0;
  for (auto _ : state) {
    const double q7 = std::uniform_real_distribution<>(lower, upper)(random);
    ik->solveAll(workload().of_configurations[i++ % kPoses], q7, answers);
    found += answers.size();
  }
  state.counters["valid_per_second"] =
      benchmark::Counter(static_cast<double>(found), benchmark::Counter::kIsRate);
}

void forwardKinematics(benchmark::State& state) {
  Eigen::VectorXd q = Eigen::VectorXd::Constant(7, -0.5);
  for (auto _ : state) benchmark::DoNotOptimize(workload().robot->tcpPose(q.data()));
}

BENCHMARK(forwardKinematics);
BENCHMARK_CAPTURE(attempt, kdl, makeKdlInverseKinematics);
BENCHMARK_CAPTURE(attempt, damped, makeDampedInverseKinematics);
BENCHMARK_CAPTURE(attempt, analytic, makeInverseKinematics);
BENCHMARK(solveAll);
BENCHMARK_CAPTURE(solve, kdl, makeKdlInverseKinematics)->Arg(8)->Arg(20);
BENCHMARK_CAPTURE(solve, damped, makeDampedInverseKinematics)->Arg(8)->Arg(20);
BENCHMARK_CAPTURE(solve, analytic, makeInverseKinematics)->Arg(8)->Arg(32)->Arg(128);

}  // namespace
}  // namespace b4p

BENCHMARK_MAIN();
