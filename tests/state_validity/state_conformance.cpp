// SPDX-License-Identifier: BSD-3-Clause
// Promises of every checker about single configurations: obstacles of every shape are solid and have their
// true size, padding is as stated, the held object counts, fingers excepted, limits hold, bad input is
// refused.
#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "tests/state_validity/checkers.h"
#include "tests/state_validity/crane.h"

namespace b4p::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr double kStep_m = 0.01;
constexpr double kPadding_m = 0.5 * kStep_m;
constexpr double kHair_m = 1e-4;

using StateConformance = CheckerConformance;
INSTANTIATE_TEST_SUITE_P(Checkers, StateConformance, allCheckers(), checkerName);

Obstacle obstacle(Shape shape, const Eigen::Vector3d& position = Eigen::Vector3d::Zero()) {
  return {"obstacle", placedAt(std::move(shape), position)};
}

CollisionProblem probeProblem(Shape probe, Obstacle target) {
  return {Crane().with("tool", std::move(probe)).build(), {std::move(target)}, {}, kStep_m};
}

TEST_P(StateConformance, ProbeWhollyInsideAnObstacleCollides) {
  std::mt19937_64 random(1);
  for (const NamedShape& target : oneOfEach()) {
    const auto context = makeContext(probeProblem(Sphere{0.001}, obstacle(target.shape)));
    const CraneConfiguration centre{};
    EXPECT_FALSE(context->isFree(centre.data(), nullptr)) << target.name;
    for (int i = 0; i < 200; ++i) {
      const CraneConfiguration q = randomCrane(random, 0.05);
      EXPECT_FALSE(context->isFree(q.data(), nullptr))
          << target.name << " " << q[0] << " " << q[1] << " " << q[2];
    }
  }
}

TEST_P(StateConformance, ObstacleWhollyInsideTheProbeCollides) {
  const Shape small_shapes[] = {Box{{0.02, 0.02, 0.02}}, Sphere{0.01}, Cylinder{0.01, 0.02},
                                Capsule{0.01, 0.01}, blockMesh({0.02, 0.02, 0.02})};
  for (const NamedShape& probe : oneOfEach())
    for (const Shape& small : small_shapes) {
      const auto context = makeContext(probeProblem(probe.shape, obstacle(small, {0.01, 0.02, -0.01})));
      const CraneConfiguration q{};
      EXPECT_FALSE(context->isFree(q.data(), nullptr)) << probe.name << " around shape " << small.index();
    }
}

TEST_P(StateConformance, EveryPairOfShapesHasItsTrueSizePlusPadding) {
  for (const NamedShape& probe : oneOfEach())
    for (const NamedShape& target : oneOfEach()) {
      const auto context = makeContext(probeProblem(probe.shape, obstacle(target.shape)));
      for (const double side : {-1.0, 1.0}) {
        const double touch = 2.0 * kShapeReach_m + kPadding_m;
        const CraneConfiguration outside{side * (touch + kHair_m), 0.0, 0.0, 0.0};
        const CraneConfiguration inside{side * (touch - kHair_m), 0.0, 0.0, 0.0};
        EXPECT_TRUE(context->isFree(outside.data(), nullptr)) << probe.name << " beside " << target.name;
        EXPECT_FALSE(context->isFree(inside.data(), nullptr))
            << probe.name << " in padding of " << target.name;
      }
    }
}

TEST_P(StateConformance, PaddingIsHalfAStepUnlessGiven) {
  CollisionProblem problem = probeProblem(Sphere{0.1}, obstacle(Box{{0.2, 0.2, 0.2}}));
  EXPECT_DOUBLE_EQ(make(problem)->problem().padding_m, kPadding_m);
  problem.padding_m = 0.0;
  const auto context = makeContext(problem);
  const CraneConfiguration outside{0.2 + kHair_m, 0.0, 0.0, 0.0}, inside{0.2 - kHair_m, 0.0, 0.0, 0.0};
  EXPECT_TRUE(context->isFree(outside.data(), nullptr));
  EXPECT_FALSE(context->isFree(inside.data(), nullptr));
}

TEST_P(StateConformance, SpheresAgainstBoxesAgreeWithTheDistanceFormula) {
  std::mt19937_64 random(2);
  const Eigen::Vector3d half(0.3, 0.5, 0.2);
  Obstacle box = obstacle(Box{2.0 * half});
  box.shape.X_BS = Eigen::Translation3d(0.2, -0.1, 0.3) *
                   Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, -0.5).normalized());
  const double radius = 0.15;
  const auto context = makeContext(probeProblem(Sphere{radius}, box));
  int colliding = 0;
  for (int i = 0; i < 20000; ++i) {
    const CraneConfiguration q = randomCrane(random, 0.9);
    const Eigen::Vector3d p_S = box.shape.X_BS.inverse() * Eigen::Vector3d(q[0], q[1], q[2]);
    const double clearance = (p_S.cwiseAbs() - half).cwiseMax(0.0).norm() - radius - kPadding_m;
    if (std::abs(clearance) < 1e-6) continue;
    ASSERT_EQ(context->isFree(q.data(), nullptr), clearance > 0.0) << "clearance " << clearance;
    colliding += clearance < 0.0;
  }
  EXPECT_GT(colliding, 1000);
  EXPECT_LT(colliding, 19000);
}

TEST_P(StateConformance, HeldObjectCountsOnlyWhileHeldAndWhereTheGraspPutsIt) {
  CollisionProblem problem = probeProblem(Sphere{0.01}, obstacle(Box{{0.1, 0.1, 0.1}}, {1.0, 0.0, 0.0}));
  problem.object = {placedAt(Box{{0.1, 0.1, 0.1}}, {0.0, 0.0, 0.1}), placedAt(Sphere{0.05}, {0.0, 0.0, 0.4})};
  const auto context = makeContext(problem);
  const Grasp ahead = graspWithObjectAt({0.5, 0.0, 0.0});
  const auto isFree = [&](double x, double z, double yaw, const Grasp* held) {
    const CraneConfiguration q{x, 0.0, z, yaw};
    return context->isFree(q.data(), held);
  };
  EXPECT_FALSE(isFree(0.5, -0.1, 0.0, &ahead)) << "the box";
  EXPECT_FALSE(isFree(0.5, -0.4, 0.0, &ahead)) << "the sphere";
  EXPECT_TRUE(isFree(0.5, -0.1, 0.0, nullptr));
  EXPECT_TRUE(isFree(0.5, -0.1, 3.0, &ahead)) << "turned away";
  const Grasp behind = graspWithObjectAt({-0.5, 0.0, 0.0});
  EXPECT_TRUE(isFree(0.5, -0.1, 0.0, &behind));
  EXPECT_FALSE(isFree(1.5, -0.1, 0.0, &behind));
}

TEST_P(StateConformance, HeldObjectCollidesWithLinksButNotWithFingers) {
  CollisionProblem problem{Crane()
                               .with("column", placedAt(Box{{0.2, 0.2, 0.2}}, {0.0, 0.0, 0.5}))
                               .with("tool", placedAt(Box{{0.1, 0.1, 0.02}}, {0.0, 0.0, 0.1}))
                               .with("left", Box{{0.02, 0.02, 0.1}})
                               .with("right", Box{{0.02, 0.02, 0.1}})
                               .build(),
                           {},
                           {placedAt(Box{{0.05, 0.3, 0.05}}, Eigen::Vector3d::Zero())},
                           kStep_m};
  const auto context = makeContext(problem);
  const CraneConfiguration q{};
  const Grasp between_fingers = graspWithObjectAt({0.0, 0.0, 0.0});
  EXPECT_EQ(context->describeCollision(q.data(), &between_fingers), "");
  const Grasp in_palm = graspWithObjectAt({0.0, 0.0, 0.1});
  EXPECT_EQ(context->describeCollision(q.data(), &in_palm), "held object, tool");
  const Grasp in_column = graspWithObjectAt({0.0, 0.0, 0.45});
  EXPECT_EQ(context->describeCollision(q.data(), &in_column), "held object, column");
  EXPECT_TRUE(context->isFree(q.data(), &between_fingers));
  EXPECT_FALSE(context->isFree(q.data(), &in_palm));
  EXPECT_FALSE(context->isFree(q.data(), &in_column));
}

// The object does not move relative to the link that carries it, so that it may come closer than the padding.
TEST_P(StateConformance, HeldObjectMayComeCloseToTheLinkThatCarriesIt) {
  CollisionProblem problem{Crane().with("tool", placedAt(Box{{0.1, 0.1, 0.1}}, {0.0, 0.0, 0.1})).build(),
                           {},
                           {placedAt(Box{{0.1, 0.1, 0.1}}, Eigen::Vector3d::Zero())},
                           kStep_m};
  const auto context = makeContext(problem);
  const CraneConfiguration q{};
  const Grasp near = graspWithObjectAt({0.0, 0.0, -kHair_m}), into = graspWithObjectAt({0.0, 0.0, kHair_m});
  EXPECT_TRUE(context->isFree(q.data(), &near));
  EXPECT_FALSE(context->isFree(q.data(), &into));
}

TEST_P(StateConformance, FingersOpenAsTheGraspSaysAndFullyWithoutOne) {
  CollisionProblem problem{Crane().with("left", Box{{0.02, 0.02, 0.02}}).build(),
                           {obstacle(Box{{0.02, 0.02, 0.02}}, {0.0, 0.1, 0.0})},
                           {},
                           kStep_m};
  const auto context = makeContext(problem);
  const CraneConfiguration q{};
  const Grasp closed = graspWithObjectAt({0.0, 0.0, 0.0}, 0.0),
              open = graspWithObjectAt({0.0, 0.0, 0.0}, 0.2);
  EXPECT_TRUE(context->isFree(q.data(), &closed));
  EXPECT_FALSE(context->isFree(q.data(), &open));
  EXPECT_FALSE(context->isFree(q.data(), nullptr));
}

TEST_P(StateConformance, LinksCollideUnlessJoinedOrAllowed) {
  const PlacedShape ball = placedAt(Sphere{0.1}, Eigen::Vector3d::Zero());
  const CraneConfiguration q{};
  const auto describe = [&](const Crane& crane) {
    return makeContext({crane.build(), {}, {}, kStep_m})->describeCollision(q.data(), nullptr);
  };
  EXPECT_EQ(describe(Crane().with("column", ball).with("tool", ball)), "") << "joined by one joint";
  EXPECT_EQ(describe(Crane().with("bridge", ball).with("tool", ball)), "tool, bridge");
  EXPECT_EQ(describe(Crane().with("bridge", ball).with("tool", ball).allow("bridge", "tool")), "");
  EXPECT_EQ(describe(Crane().with("base", ball).with("tool", ball)), "tool, base")
      << "with a link that stands still";
}

TEST_P(StateConformance, OutsideTheJointLimitsIsNotFree) {
  const auto context = makeContext(probeProblem(Sphere{0.1}, obstacle(Sphere{0.1})));
  const CraneConfiguration inside{Crane::kReach_m, 0.0, 0.0, 0.0},
      outside{Crane::kReach_m + 1e-9, 0.0, 0.0, 0.0};
  EXPECT_TRUE(context->isFree(inside.data(), nullptr));
  EXPECT_FALSE(context->isFree(outside.data(), nullptr));
  EXPECT_NE(context->describeCollision(outside.data(), nullptr), "");
  EXPECT_TRUE(context->isEdgeFree(inside.data(), inside.data(), nullptr));
  EXPECT_FALSE(context->isEdgeFree(inside.data(), outside.data(), nullptr));
  EXPECT_FALSE(context->isEdgeFree(outside.data(), inside.data(), nullptr));
}

TEST_P(StateConformance, NonFiniteInputThrows) {
  CollisionProblem problem = probeProblem(Sphere{0.1}, obstacle(Sphere{0.1}));
  problem.object = {placedAt(Sphere{0.1}, Eigen::Vector3d::Zero())};
  const auto context = makeContext(problem);
  const CraneConfiguration good{1.0, 1.0, 1.0, 0.0};
  const auto expectThrow = [&](const double* q, const Grasp* held) {
    EXPECT_THROW(context->isFree(q, held), std::invalid_argument);
    EXPECT_THROW(context->isEdgeFree(good.data(), q, held), std::invalid_argument);
    EXPECT_THROW(context->isEdgeFree(q, good.data(), held), std::invalid_argument);
    EXPECT_THROW(context->freeFraction(good.data(), q, held), std::invalid_argument);
    EXPECT_THROW(context->describeCollision(q, held), std::invalid_argument);
  };
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (std::size_t i = 0; i < good.size(); ++i) {
      CraneConfiguration q = good;
      q[i] = bad;
      expectThrow(q.data(), nullptr);
    }
    Grasp grasp = graspWithObjectAt({0.0, 0.0, 0.0});
    grasp.X_OT.translation().y() = bad;
    expectThrow(good.data(), &grasp);
    grasp = graspWithObjectAt({0.0, 0.0, 0.0});
    grasp.opening_m = bad;
    expectThrow(good.data(), &grasp);
  }
  EXPECT_TRUE(context->isFree(good.data(), nullptr)) << "still usable afterwards";
}

TEST_P(StateConformance, DescribeCollisionNamesThePair) {
  const auto context =
      makeContext(probeProblem(Sphere{0.1}, {"shelf", placedAt(Sphere{0.1}, {1.0, 0.0, 0.0})}));
  const CraneConfiguration colliding{1.0, 0.0, 0.0, 0.0}, free{};
  EXPECT_EQ(context->describeCollision(colliding.data(), nullptr), "tool, shelf");
  EXPECT_EQ(context->describeCollision(free.data(), nullptr), "");
}

TEST_P(StateConformance, BadProblemsAreRefused) {
  const auto message = [this](const CollisionProblem& problem) -> std::string {
    try {
      make(problem);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  const CollisionProblem good = probeProblem(Sphere{0.1}, obstacle(Sphere{0.1}));
  EXPECT_EQ(message(good), "");
  CollisionProblem bad = good;
  bad.robot = nullptr;
  EXPECT_THAT(message(bad), HasSubstr("robot"));
  for (const double step : {0.0, -0.01, std::numeric_limits<double>::quiet_NaN()}) {
    bad = good;
    bad.edge_step_m = step;
    EXPECT_THAT(message(bad), HasSubstr("edge_step_m"));
  }
  bad = good;
  bad.padding_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(message(bad), HasSubstr("padding_m"));
  bad = good;
  bad.obstacles[0].shape.shape = Sphere{-1.0};
  EXPECT_THAT(message(bad), HasSubstr("obstacle"));
  bad = good;
  bad.obstacles[0].shape.X_BS.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(message(bad), HasSubstr("obstacle"));
}

TEST_P(StateConformance, AnObstacleInTheRobotsFootIsRefused) {
  const auto robot =
      Crane().with("base", Sphere{0.1}).with("tool", placedAt(Sphere{0.1}, {0.0, 0.0, 1.0})).build();
  const CollisionProblem apart{robot, {obstacle(Sphere{0.1}, {0.2 + kHair_m, 0.0, 0.0})}, {}, kStep_m};
  EXPECT_NO_THROW(make(apart)) << "what stands still needs no padding";
  const CollisionProblem into{robot, {obstacle(Sphere{0.1}, {0.2 - kHair_m, 0.0, 0.0})}, {}, kStep_m};
  try {
    make(into);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("base"), HasSubstr("obstacle")));
  }
}

}  // namespace
}  // namespace b4p::testing
