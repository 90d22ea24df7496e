// SPDX-License-Identifier: BSD-3-Clause
// Promises of every checker about edges: both ends are checked, the held object counts all along, nothing is
// jumped over, freeFraction keeps its contract, an edge found free is free between the checks as well.
#include <algorithm>
#include <cmath>

#include "tests/state_validity/checkers.h"
#include "tests/state_validity/crane.h"

namespace b4p::testing {
namespace {

constexpr double kStep_m = 0.01;

using EdgeConformance = CheckerConformance;
INSTANTIATE_TEST_SUITE_P(Checkers, EdgeConformance, allCheckers(), checkerName);

Obstacle block(const Eigen::Vector3d& size, const Eigen::Vector3d& position) {
  return {"block", placedAt(Box{size}, position)};
}

template <std::size_t N>
std::array<double, N> between(const std::array<double, N>& q1, const std::array<double, N>& q2, double t) {
  std::array<double, N> q;
  for (std::size_t i = 0; i < N; ++i) q[i] = q1[i] + t * (q2[i] - q1[i]);
  return q;
}

TEST_P(EdgeConformance, BothEndsAndTheMiddleAreChecked) {
  const auto context = makeContext(
      {Crane().with("tool", Sphere{0.1}).build(), {block({0.1, 0.1, 0.1}, {0.0, 0.0, 0.0})}, {}, kStep_m});
  const CraneConfiguration in{}, left{-1.0, 0.0, 0.0, 0.0}, right{1.0, 0.0, 0.0, 0.0},
      above{0.0, 0.0, 1.0, 0.0};
  EXPECT_FALSE(context->isEdgeFree(in.data(), left.data(), nullptr)) << "first point";
  EXPECT_LT(context->freeFraction(in.data(), left.data(), nullptr), 0.0);
  EXPECT_FALSE(context->isEdgeFree(left.data(), in.data(), nullptr)) << "last point";
  EXPECT_FALSE(context->isEdgeFree(left.data(), right.data(), nullptr)) << "on the way";
  EXPECT_TRUE(context->isEdgeFree(left.data(), above.data(), nullptr));
  EXPECT_FALSE(context->isEdgeFree(in.data(), in.data(), nullptr)) << "no length";
  EXPECT_TRUE(context->isEdgeFree(left.data(), left.data(), nullptr)) << "no length";
  EXPECT_EQ(context->freeFraction(left.data(), left.data(), nullptr), 1.0);
}

TEST_P(EdgeConformance, HeldObjectCollidesAtTheStartOnTheWayAndAtTheEnd) {
  const CraneConfiguration from{-1.0, 0.0, 0.0, 0.0}, to{1.0, 0.0, 0.0, 0.0};
  const Grasp below = graspWithObjectAt({0.0, 0.0, -0.5});
  for (const double x : {-1.0, 0.1, 1.0}) {
    const auto context = makeContext({Crane().with("tool", Sphere{0.1}).build(),
                                      {block({0.1, 0.1, 0.1}, {x, 0.0, -0.5})},
                                      {placedAt(Box{{0.1, 0.1, 0.1}}, Eigen::Vector3d::Zero())},
                                      kStep_m});
    EXPECT_TRUE(context->isEdgeFree(from.data(), to.data(), nullptr)) << "empty, block at " << x;
    EXPECT_FALSE(context->isEdgeFree(from.data(), to.data(), &below)) << "block at " << x;
    EXPECT_EQ(context->freeFraction(from.data(), to.data(), &below) < 0.0, x == -1.0);
    const Grasp above = graspWithObjectAt({0.0, 0.0, 0.5});
    EXPECT_TRUE(context->isEdgeFree(from.data(), to.data(), &above)) << "another grasp, block at " << x;
  }
}

// Turning sweeps what is far from the axis much farther than the hand.
TEST_P(EdgeConformance, ThinWallsAreNeverJumped) {
  std::mt19937_64 random(3);
  const double step_m = 0.05;
  const auto context = makeContext({Crane().with("tool", Sphere{0.02}).build(),
                                    {block({0.001, 20.0, 20.0}, {0.5, 0.0, 0.0})},
                                    {placedAt(Sphere{0.02}, Eigen::Vector3d::Zero())},
                                    step_m});
  const Grasp far = graspWithObjectAt({1.0, 0.0, 0.0});
  int crossings = 0;
  for (int i = 0; i < 3000; ++i) {
    const CraneConfiguration q1 = randomCrane(random), q2 = randomCrane(random);
    const double side1 = q1[0] + std::cos(q1[3]) - 0.5, side2 = q2[0] + std::cos(q2[3]) - 0.5;
    if (side1 * side2 >= 0.0) continue;
    ++crossings;
    ASSERT_FALSE(context->isEdgeFree(q1.data(), q2.data(), &far));
    ASSERT_LT(context->freeFraction(q1.data(), q2.data(), &far), 1.0);
  }
  EXPECT_GT(crossings, 500);
}

CollisionProblem roomFullOfShapes() {
  CollisionProblem problem{Crane()
                               .with("column", placedAt(Box{{0.1, 0.1, 0.4}}, {0.0, 0.0, 0.4}))
                               .with("tool", Capsule{0.05, 0.2})
                               .with("left", Box{{0.03, 0.02, 0.1}})
                               .build(),
                           {},
                           {placedAt(blockMesh({0.3, 0.1, 0.1}), {0.1, 0.0, 0.0}),
                            placedAt(Cylinder{0.05, 0.3}, {-0.1, 0.0, 0.0})},
                           kStep_m};
  std::mt19937_64 random(4);
  for (int round = 0; round < 5; ++round)
    for (const NamedShape& shape : oneOfEach()) {
      const CraneConfiguration at = randomCrane(random, 1.2);
      PlacedShape placed = placedAt(shape.shape, {at[0], at[1], at[2]});
      placed.X_BS.rotate(Eigen::AngleAxisd(at[3], Eigen::Vector3d(at[1], at[2], at[0]).normalized()));
      problem.obstacles.push_back({shape.name + std::to_string(round), placed});
    }
  return problem;
}

TEST_P(EdgeConformance, FreeEdgesAreFreeBetweenTheChecks) {
  CollisionProblem problem = roomFullOfShapes();
  const auto context = makeContext(problem);
  problem.padding_m = 0.0;
  const auto bare = makeContext(problem);
  const Grasp grasp = graspWithObjectAt({0.1, 0.1, -0.3});
  std::mt19937_64 random(5);
  int free = 0;
  for (int i = 0; i < 1000; ++i) {
    const CraneConfiguration q1 = randomCrane(random, 1.2), q2 = randomCrane(random, 1.2);
    if (!context->isEdgeFree(q1.data(), q2.data(), &grasp)) continue;
    ++free;
    // 100 times as fine as the edge's checks: no point moves by more than 5 m.
    const int count = free <= 20 ? static_cast<int>(100.0 * 5.0 / kStep_m) : 500;
    for (int k = 0; k <= count; ++k) {
      const CraneConfiguration q = between(q1, q2, static_cast<double>(k) / count);
      ASSERT_TRUE(bare->isFree(q.data(), &grasp));
    }
  }
  EXPECT_GT(free, 40);
}

TEST_P(EdgeConformance, FreeFractionKeepsItsContract) {
  const auto context = makeContext(roomFullOfShapes());
  const Grasp grasp = graspWithObjectAt({0.1, 0.1, -0.3});
  std::mt19937_64 random(6);
  int blocked_start = 0, blocked = 0, free = 0;
  for (int i = 0; i < 3000; ++i) {
    const CraneConfiguration q1 = randomCrane(random, 1.2), q2 = randomCrane(random, 1.2);
    const double t = context->freeFraction(q1.data(), q2.data(), &grasp);
    ASSERT_LE(t, 1.0);
    ASSERT_EQ(t >= 0.0, context->isFree(q1.data(), &grasp));
    ASSERT_EQ(t == 1.0, context->isEdgeFree(q1.data(), q2.data(), &grasp));
    ASSERT_EQ(t == 1.0, context->isEdgeFree(q2.data(), q1.data(), &grasp)) << "backwards";
    if (t >= 0.0) {
      const CraneConfiguration reached = t == 1.0 ? q2 : between(q1, q2, t);
      ASSERT_TRUE(context->isEdgeFree(q1.data(), reached.data(), &grasp)) << "t = " << t;
      ASSERT_TRUE(context->isFree(reached.data(), &grasp));
    }
    ++(t < 0.0 ? blocked_start : t < 1.0 ? blocked : free);
  }
  EXPECT_GT(std::min({blocked_start, blocked, free}), 50);
}

TEST_P(EdgeConformance, FreeFractionReachesTheObstacleWithinAStep) {
  const auto context = makeContext(
      {Crane().with("tool", Sphere{0.1}).build(), {block({0.2, 9.0, 9.0}, {1.0, 0.0, 0.0})}, {}, kStep_m});
  std::mt19937_64 random(7);
  for (int i = 0; i < 500; ++i) {
    CraneConfiguration q1 = randomCrane(random), q2 = randomCrane(random);
    q1[0] = -std::abs(q1[0]);
    q2[0] = 1.0;
    const double t = context->freeFraction(q1.data(), q2.data(), nullptr);
    const Eigen::Vector3d way(q2[0] - q1[0], q2[1] - q1[1], q2[2] - q1[2]);
    const double contact = (1.0 - 0.1 - 0.1 - 0.5 * kStep_m - q1[0]) / way.x();
    EXPECT_LE(t, contact + 1e-9);
    EXPECT_GE(t, contact - 1.5 * kStep_m / way.norm());
  }
}

TEST_P(EdgeConformance, FreeFractionStopsAtTheJointLimits) {
  const auto context = makeContext(
      {Crane().with("tool", Sphere{0.1}).build(), {block({0.2, 0.2, 0.2}, {0.0, 0.0, 0.0})}, {}, kStep_m});
  const CraneConfiguration inside{2.0, 0.0, 0.0, 0.0}, outside{4.0, 0.0, 0.0, 0.0};
  const double t = context->freeFraction(inside.data(), outside.data(), nullptr);
  EXPECT_NEAR(t, 0.5, kStep_m);
  const CraneConfiguration reached = between(inside, outside, t);
  EXPECT_TRUE(context->isEdgeFree(inside.data(), reached.data(), nullptr));
  EXPECT_LT(context->freeFraction(outside.data(), inside.data(), nullptr), 0.0);
}

}  // namespace
}  // namespace b4p::testing
