// SPDX-License-Identifier: BSD-3-Clause
// The shortcut through an edge's samples answers as checking every one of them does.
#include <gtest/gtest.h>

#include "state_validity/fcl_context.h"
#include "state_validity/separation.h"
#include "tests/state_validity/crane.h"
#include "tests/state_validity/panda.h"

namespace b4p::testing {
namespace {

TEST(EdgeSearch, AnswersAsEverySampleTogether) {
  const CollisionProblem problem = pandaProblem(20, 4);
  const auto world = std::make_shared<const FclWorld>(problem);
  FclContext single(world);
  PosedPieces pieces(world);
  EdgeSearch search(pieces);
  const Grasp grasp = pandaGrasp();
  std::mt19937_64 random(40);
  int free = 0, blocked = 0;
  for (int i = 0; i < 500; ++i) {
    const Grasp* held = i % 2 == 0 ? &grasp : nullptr;
    const PandaConfiguration q1 = randomPanda(random);
    PandaConfiguration q2 = randomPanda(random);
    const double length = i % 5 == 0 ? 1.0 : 0.2;
    for (std::size_t j = 0; j < q2.size(); ++j) q2[j] = q1[j] + length * (q2[j] - q1[j]);
    pieces.hold(held);
    const EdgeSamples samples(q1.data(), q2.data(), 7, pieces.sweptBound(q1.data(), q2.data()),
                              problem.edge_step_m);
    std::int64_t first = 0;
    for (PandaConfiguration q = q1; first <= samples.last(); ++first) {
      samples.at(first, q.data());
      if (!single.isFree(q.data(), held)) break;
    }
    ASSERT_EQ(search.allFree(samples), first > samples.last());
    ASSERT_EQ(search.firstBlocked(samples, samples.last()), first);
    ++(first > samples.last() ? free : blocked);
  }
  EXPECT_GT(std::min(free, blocked), 100);
}

// Boxes along the axes have a distance that anybody can work out; turning both together changes nothing.
TEST(Separation, IsALowerBoundAndCloseToTheDistance) {
  std::mt19937_64 random(41);
  std::uniform_real_distribution<> size(0.01, 0.4), place(-1.0, 1.0);
  const auto vector = [&](auto& range) {
    return Eigen::Vector3d(range(random), range(random), range(random));
  };
  constexpr double kEnough_m = 0.1, kNeverClear_m = 100.0;
  int far_apart = 0, recognised = 0;
  for (int i = 0; i < 5000; ++i) {
    const ShapeBounds a{vector(place), vector(size), 0.1 * size(random)}, b{vector(place), vector(size), 0.0};
    const Eigen::Isometry3d X = Eigen::Translation3d(vector(place)) *
                                Eigen::AngleAxisd(3.0 * place(random), vector(place).normalized());
    const double distance =
        ((a.centre - b.centre).cwiseAbs() - a.half - b.half).cwiseMax(0.0).norm() - a.radius;
    const double bound = separation(a.posed(X), b.posed(X), 0.0, kNeverClear_m, kEnough_m);
    ASSERT_LE(bound, std::max(0.0, distance) + 1e-12);
    far_apart += distance > 1.2 * kEnough_m;
    recognised += bound > kEnough_m;
  }
  EXPECT_GT(far_apart, 500);
  EXPECT_GT(recognised, 0.95 * far_apart);
}

TEST(EdgeSamples, AreTheSameBackwardsAndEndExactly) {
  const CraneConfiguration q1{0.1, -0.7, 2.3, 0.3}, q2{1.7, 0.9, -1.1, -0.2};
  const EdgeSamples forwards(q1.data(), q2.data(), 4, 1.0, 0.007),
      backwards(q2.data(), q1.data(), 4, 1.0, 0.007);
  ASSERT_EQ(forwards.last(), 143);
  for (std::int64_t k = 0; k <= forwards.last(); ++k) {
    CraneConfiguration a, b;
    forwards.at(k, a.data());
    backwards.at(forwards.last() - k, b.data());
    EXPECT_EQ(a, b);
    if (k == 0) {
      EXPECT_EQ(a, q1);
    }
    if (k == forwards.last()) {
      EXPECT_EQ(a, q2);
    }
  }
}

TEST(EdgeSamples, LieNoFartherApartThanTheStep) {
  const CraneConfiguration q{};
  const auto last = [&q](double swept_m) { return EdgeSamples(q.data(), q.data(), 4, swept_m, 0.1).last(); };
  EXPECT_EQ(last(0.0), 1);
  EXPECT_EQ(last(0.1), 1);
  EXPECT_EQ(last(0.1001), 2);
  EXPECT_EQ(last(0.3), 3) << "0.3 / 0.1 rounds to more than 3";
  EXPECT_EQ(last(7.05), 71);
}

}  // namespace
}  // namespace b4p::testing
