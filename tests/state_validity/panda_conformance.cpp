// SPDX-License-Identifier: BSD-3-Clause
// Promises of every checker on a real arm: self collisions are found and not invented, many threads get the
// verdicts that one gets, edges found free are free between the checks.
#include <algorithm>
#include <thread>

#include "tests/state_validity/checkers.h"
#include "tests/state_validity/panda.h"

namespace b4p::testing {
namespace {

using PandaConformance = CheckerConformance;
INSTANTIATE_TEST_SUITE_P(Checkers, PandaConformance, allCheckers(), checkerName);

constexpr PandaConfiguration kReady{0.0, -0.785, 0.0, -2.356, 0.0, 1.571, 0.785};

TEST_P(PandaConformance, CommonConfigurationsAreFreeOfSelfCollision) {
  const auto context = makeContext({panda(), {}, {}, 0.01});
  const PandaConfiguration configurations[] = {
      kReady,
      {0.0, 0.0, 0.0, -1.5708, 0.0, 1.8675, 0.0},
      {0.0, -1.285, 0.0, -2.356, 0.0, 1.571, 0.785},
      {0.0, 0.5, 0.0, -1.0, 0.0, 1.5, 0.785},
      {1.5, 0.3, -1.2, -2.0, 1.0, 2.5, -1.0},
      {2.8, 1.0, 0.0, -0.5, 2.0, 2.0, 2.8},
  };
  for (const PandaConfiguration& q : configurations)
    EXPECT_EQ(context->describeCollision(q.data(), nullptr), "");
}

TEST_P(PandaConformance, FoldedOntoItselfCollides) {
  const auto context = makeContext({panda(), {}, {}, 0.01});
  const PandaConfiguration folded{0.0, -1.7, 0.0, -3.05, 0.0, 0.3, 0.785};
  EXPECT_NE(context->describeCollision(folded.data(), nullptr), "");
  EXPECT_FALSE(context->isFree(folded.data(), nullptr));
  EXPECT_FALSE(context->isEdgeFree(kReady.data(), folded.data(), nullptr));
}

TEST_P(PandaConformance, VerdictAndDescriptionAgree) {
  const auto context = makeContext(pandaProblem(20, 1));
  const Grasp grasp = pandaGrasp();
  std::mt19937_64 random(8);
  for (int i = 0; i < 3000; ++i) {
    const PandaConfiguration q = randomPanda(random);
    for (const Grasp* held : {static_cast<const Grasp*>(nullptr), &grasp})
      ASSERT_EQ(context->isFree(q.data(), held), context->describeCollision(q.data(), held).empty());
  }
}

TEST_P(PandaConformance, FreeEdgesAreFreeBetweenTheChecks) {
  CollisionProblem problem = pandaProblem(20, 2);
  const auto context = makeContext(problem);
  problem.padding_m = 0.0;
  const auto bare = makeContext(problem);
  const Grasp grasp = pandaGrasp();
  std::mt19937_64 random(9);
  int free = 0;
  for (int i = 0; i < 400; ++i) {
    const PandaConfiguration q1 = randomPanda(random), q2 = randomPanda(random);
    if (!context->isEdgeFree(q1.data(), q2.data(), &grasp)) continue;
    ++free;
    constexpr int kCount = 3000;
    for (int k = 0; k <= kCount; ++k) {
      PandaConfiguration q;
      for (std::size_t j = 0; j < q.size(); ++j) q[j] = q1[j] + (q2[j] - q1[j]) * k / kCount;
      ASSERT_TRUE(bare->isFree(q.data(), &grasp)) << bare->describeCollision(q.data(), &grasp);
    }
  }
  EXPECT_GT(free, 20);
}

// A wall across the workspace, much thinner than the step: wherever the hand changes sides it went through.
TEST_P(PandaConformance, ThinWallsAreNeverJumped) {
  PlacedShape wall{Box{{0.001, 4.0, 4.0}}, Eigen::Isometry3d::Identity()};
  wall.X_BS.translation() = Eigen::Vector3d(0.35, 0.0, 0.0);
  const auto context = makeContext({panda(), {{"wall", wall}}, {}, 0.05});
  std::mt19937_64 random(10);
  int crossings = 0;
  for (int i = 0; i < 4000; ++i) {
    const PandaConfiguration q1 = randomPanda(random), q2 = randomPanda(random);
    const double side1 = panda()->tcpPose(q1.data()).translation().x() - 0.35;
    const double side2 = panda()->tcpPose(q2.data()).translation().x() - 0.35;
    if (side1 * side2 >= 0.0) continue;
    ++crossings;
    ASSERT_FALSE(context->isEdgeFree(q1.data(), q2.data(), nullptr));
  }
  EXPECT_GT(crossings, 300);
}

TEST_P(PandaConformance, ParallelVerdictsEqualSerialOnes) {
  constexpr std::size_t kStates = 8000, kThreads = 4, kEdgeEvery = 16;
  const auto checker = make(pandaProblem(20, 3));
  std::mt19937_64 random(11);
  std::vector<PandaConfiguration> states(kStates);
  std::generate(states.begin(), states.end(), [&random] { return randomPanda(random); });
  Grasp grasps[] = {pandaGrasp(), pandaGrasp()};
  grasps[1].X_OT.translate(Eigen::Vector3d(0.0, 0.02, 0.01));

  // Each verdict depends on its index alone; every state is asked for with one grasp or without.
  const auto verdict = [&](CollisionContext& context, std::size_t i) {
    const Grasp* held = i % 3 < 2 ? &grasps[i % 3] : nullptr;
    if (i % kEdgeEvery != 0) return context.isFree(states[i].data(), held) ? 1.0 : 0.0;
    return context.freeFraction(states[i].data(), states[(i + 1) % kStates].data(), held);
  };
  std::vector<double> serial(kStates), parallel(kStates);
  const auto one = checker->makeContext();
  for (std::size_t i = 0; i < kStates; ++i) serial[i] = verdict(*one, i);

  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < kThreads; ++t)
    threads.emplace_back([&, t] {
      const auto context = checker->makeContext();
      for (std::size_t i = t; i < kStates; i += kThreads) parallel[i] = verdict(*context, i);
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(serial, parallel);
  EXPECT_GT(std::count(serial.begin(), serial.end(), 1.0), 500);
  EXPECT_GT(std::count(serial.begin(), serial.end(), 0.0), 500);
}

TEST_P(PandaConformance, ContextsOutliveTheirChecker) {
  auto context = makeContext(pandaProblem(20, 1));
  EXPECT_TRUE(context->isFree(kReady.data(), nullptr));
}

}  // namespace
}  // namespace b4p::testing
