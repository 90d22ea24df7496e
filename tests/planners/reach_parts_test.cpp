// SPDX-License-Identifier: BSD-3-Clause
// Promises of what reach planners are made of: grasps are checked when they come in; tolerance and flip; the
// goal region's distances, samples and grasps; grasps drawn once a round; steps of the Jacobian; nearest
// nodes that are not tried twice.
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/util/Console.h>

#include "planners/manipulation_state_space.h"
#include "planners/planar_arm.h"
#include "planners/reach/approach_table.h"
#include "planners/reach/jacobian_descent.h"

namespace b4p::test {
namespace {

namespace ob = ompl::base;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kPi = 3.14159265358979323846;

Eigen::Isometry3d somePose() {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translate(Eigen::Vector3d(0.3, -0.2, 0.5))
      .rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 0.5).normalized()));
  return X;
}

Eigen::Isometry3d moved(const Eigen::Isometry3d& X, double along_x_m, double about_y_rad) {
  return X * Eigen::Translation3d(along_x_m, 0, 0) * Eigen::AngleAxisd(about_y_rad, Eigen::Vector3d::UnitY());
}

Eigen::Isometry3d flipped(const Eigen::Isometry3d& X) {
  return X * Eigen::AngleAxisd(kPi, Eigen::Vector3d::UnitZ());
}

TEST(ReachTargets, BadRowsAreNamed) {
  const auto expectBad = [](const Eigen::Isometry3d& bad, const std::string& problem) {
    EXPECT_THAT(([&] {
                  ReachTargets::poses({somePose(), bad});
                }),
                ThrowsMessage<std::invalid_argument>(HasSubstr("row 2: " + problem)));
  };
  Eigen::Isometry3d pose = somePose();
  pose.translation().y() = kNan;
  expectBad(pose, "the pose is not finite");
  pose = somePose();
  pose.linear() *= 1.01;
  expectBad(pose, "the rotation of the pose is not orthonormal");
  pose = somePose();
  pose.linear().col(0) *= -1.0;
  expectBad(pose, "the rotation of the pose is not orthonormal");
  pose = somePose();
  pose.matrix()(3, 0) = 1.0;
  expectBad(pose, "the last row of the pose is not 0 0 0 1");
  EXPECT_THAT(([] {
                ReachTargets::positions({{0, 0, 0}, {0, 1, 0}, {0, kNan, 0}});
              }),
              ThrowsMessage<std::invalid_argument>(HasSubstr("row 3: the position is not finite")));
}

TEST(ReachTargets, EmptySetsAndBadTolerancesAreRefused) {
  EXPECT_THROW(ReachTargets::poses({}), std::invalid_argument);
  EXPECT_THROW(ReachTargets::positions({}), std::invalid_argument);
  for (const double bad : {0.0, -1.0, kNan, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(ReachTargets::positions({{0, 0, 0}}, bad), std::invalid_argument) << bad;
    EXPECT_THROW(ReachTargets::poses({somePose()}, {bad, 0.1, true}), std::invalid_argument) << bad;
    EXPECT_THROW(ReachTargets::poses({somePose()}, {0.1, bad, true}), std::invalid_argument) << bad;
  }
}

TEST(ReachTargets, ToleranceIsAMillimetreAndHalfADegree) {
  const ReachTargets targets = ReachTargets::poses({somePose()});
  const double half_degree = 0.5 * kPi / 180.0;
  EXPECT_TRUE(targets.within(0, somePose()));
  EXPECT_TRUE(targets.within(0, moved(somePose(), 0.99e-3, 0.99 * half_degree)));
  EXPECT_FALSE(targets.within(0, moved(somePose(), 1.01e-3, 0.0)));
  EXPECT_FALSE(targets.within(0, moved(somePose(), 0.0, 1.01 * half_degree)));
  EXPECT_NEAR(targets.distance(0, moved(somePose(), 0.101, 0.0)), 0.1, 1e-9);
  EXPECT_NEAR(targets.distance(0, moved(somePose(), 0.0, 0.2 + half_degree)), 0.2 * kMetresPerRadian, 1e-9);
}

TEST(ReachTargets, FlipAboutTheApproachAxisIsTheSameGraspUnlessToldOtherwise) {
  const ReachTargets same = ReachTargets::poses({somePose()});
  const ReachTargets other = ReachTargets::poses({somePose()}, {1e-3, 0.01, false});
  EXPECT_TRUE(same.within(0, flipped(somePose())));
  EXPECT_FALSE(other.within(0, flipped(somePose())));
  EXPECT_NEAR(other.distance(0, flipped(somePose())), kMetresPerRadian * (kPi - 0.01), 1e-6);
  const auto upside_down = somePose() * Eigen::AngleAxisd(kPi, Eigen::Vector3d::UnitX());
  EXPECT_FALSE(same.within(0, upside_down));
  EXPECT_TRUE(same.target(0, true).X_WT.isApprox(flipped(somePose()), 1e-12));
  EXPECT_NEAR(same.twistTo(0, flipped(moved(somePose(), 0.0, 0.1))).angular.norm(), 0.1, 1e-9);
}

TEST(ReachTargets, TwistLeadsToTheGrasp) {
  const ReachTargets targets = ReachTargets::poses({somePose()});
  const Eigen::Isometry3d from = moved(somePose(), 0.1, 0.3);
  const TcpTwist twist = targets.twistTo(0, from);
  Eigen::Isometry3d to = from;
  to.translation() += twist.linear;
  to.linear() = Eigen::AngleAxisd(twist.angular.norm(), twist.angular.normalized()) * from.linear();
  EXPECT_TRUE(to.isApprox(somePose(), 1e-9));
}

TEST(ReachTargets, PositionsLeaveTheOrientationFree) {
  const ReachTargets targets = ReachTargets::positions({somePose().translation()}, 0.05);
  EXPECT_TRUE(targets.within(0, moved(somePose(), 0.049, 2.0)));
  EXPECT_FALSE(targets.within(0, moved(somePose(), 0.051, 0.0)));
  EXPECT_EQ(targets.twistTo(0, moved(somePose(), 0.1, 2.0)).angular, Eigen::Vector3d::Zero());
}

const std::vector<Eigen::Isometry3d> kThreeGrasps = posesAt({-1.0, 1.0}, {0.5, 1.5, 2.5});

TEST(ReachGoal, NeedsJointValuesWithLimitsAndARobotThatFits) {
  const auto arm = std::make_shared<PlanarArm>();
  const ReachTargets targets = ReachTargets::poses(kThreeGrasps);
  const auto over = [&](const ob::StateSpacePtr& space) {
    ReachGoal goal(std::make_shared<ob::SpaceInformation>(space), arm, targets);
  };
  const auto reals = [](unsigned dimension, double high) {
    auto space = std::make_shared<ob::RealVectorStateSpace>(dimension);
    space->setBounds(-1.0, high);
    return space;
  };
  EXPECT_NO_THROW(over(reals(3, 1.0)));
  EXPECT_THROW(over(reals(2, 1.0)), std::invalid_argument);
  EXPECT_THROW(over(std::make_shared<ob::SO2StateSpace>()), std::invalid_argument);
  EXPECT_THROW(over(reals(3, std::numeric_limits<double>::infinity())), std::invalid_argument);
  EXPECT_THROW(ReachGoal(std::make_shared<ob::SpaceInformation>(reals(3, 1.0)), nullptr, targets),
               std::invalid_argument);
}

TEST(ReachGoal, DistanceIsZeroExactlyAtAGraspAndInfiniteOutsideTheLimits) {
  const ArmProblem setup(ReachTargets::poses(kThreeGrasps));
  auto sample = setup.at(0, 0, 0);
  setup.goal->sampleGoal(sample.get());
  EXPECT_EQ(setup.goal->distanceGoal(sample.get()), 0.0);
  EXPECT_TRUE(setup.goal->isSatisfied(sample.get()));
  EXPECT_NE(setup.goal->graspOf(sample.get()), kNoGrasp);

  const auto away = setup.at(0, 0, 0);
  EXPECT_GT(setup.goal->distanceGoal(away.get()), 4.0);  // the grasps are that far from (3, 0)
  EXPECT_FALSE(setup.goal->isSatisfied(away.get()));
  EXPECT_EQ(setup.goal->graspOf(away.get()), kNoGrasp);
  for (const double bad : {3.0, kNan, std::numeric_limits<double>::infinity()})
    EXPECT_TRUE(std::isinf(setup.goal->distanceGoal(setup.at(0, bad, 0).get()))) << bad;
}

TEST(ReachGoal, SamplesEachGraspOnceARound) {
  const ArmProblem setup(ReachTargets::poses(kThreeGrasps));
  setup.goal->setAttempts(100);
  auto sample = setup.at(0, 0, 0);
  for (int round = 0; round < 5; ++round) {
    std::set<GraspId> seen;
    for (std::size_t i = 0; i < kThreeGrasps.size(); ++i) {
      setup.goal->sampleGoal(sample.get());
      seen.insert(setup.goal->graspOf(sample.get()));
    }
    EXPECT_EQ(seen, (std::set<GraspId>{0, 1, 2}));
  }
}

TEST(ReachGoal, SampleWithoutAnswerIsOutsideTheLimitsAndFinite) {
  const ArmProblem setup(ReachTargets::poses(kThreeGrasps));
  setup.arm->can_solve = false;
  auto sample = setup.at(0, 0, 0);
  setup.goal->sampleGoal(sample.get());
  EXPECT_FALSE(setup.si->satisfiesBounds(sample.get()));
  EXPECT_NEAR(sample[0], PlanarArm::kLimit_rad, 1e-4);
  EXPECT_EQ(setup.arm->inverse_calls, setup.goal->attempts());
}

TEST(ReachGoal, NeverThrowsOutOfASample) {
  ompl::msg::noOutputHandler();
  const ArmProblem setup(ReachTargets::poses(kThreeGrasps));
  setup.arm->before_inverse = [](const ReachTarget&) { throw 42; };
  auto sample = setup.at(0, 0, 0);
  EXPECT_NO_THROW(setup.goal->sampleGoal(sample.get()));
  EXPECT_FALSE(setup.si->satisfiesBounds(sample.get()));
}

// A solver that claims success without having come near the grasp.
TEST(ReachGoal, AnswersOfInverseKinematicsAreChecked) {
  struct Boaster : PlanarArm {
    struct Context : PlanarArmContext {
      using PlanarArmContext::PlanarArmContext;
      bool inverse(const ReachTarget&, std::mt19937_64&, double* q) override {
        q[0] = q[1] = q[2] = 0.0;
        return true;
      }
    };
    std::unique_ptr<ReachContext> makeContext() const override { return std::make_unique<Context>(*this); }
  };
  const ArmProblem setup(ReachTargets::poses(kThreeGrasps));
  const ReachGoal goal(setup.si, std::make_shared<Boaster>(), ReachTargets::poses(kThreeGrasps));
  auto sample = setup.at(0, 0, 0);
  goal.sampleGoal(sample.get());
  EXPECT_FALSE(setup.si->satisfiesBounds(sample.get()));
}

TEST(ReachGoal, OneSeedGivesTheSameSamples) {
  const ArmProblem setup(ReachTargets::positions({{-1.0, 1.0, 0.0}}));
  const auto draw = [&](std::uint64_t seed) {
    setup.goal->seed(seed);
    std::vector<double> values;
    auto sample = setup.at(0, 0, 0);
    for (int i = 0; i < 10; ++i) {
      setup.goal->sampleGoal(sample.get());
      for (unsigned j = 0; j < 3; ++j) values.push_back(sample[j]);
    }
    return values;
  };
  EXPECT_EQ(draw(1), draw(1));
  EXPECT_NE(draw(1), draw(2));
}

TEST(ReachGoal, ManyThreadsMayAskAtOnce) {
  const ArmProblem setup(ReachTargets::poses(kThreeGrasps));
  std::atomic<int> wrong{0};
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&] {
      auto sample = setup.at(0, 0, 0);
      for (int i = 0; i < 200; ++i) {
        setup.goal->sampleGoal(sample.get());
        if (setup.goal->graspOf(sample.get()) == kNoGrasp) ++wrong;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

TEST(ReachGoal, HandThatHoldsSomethingIsNotInTheGoal) {
  ob::RealVectorBounds bounds(3);
  bounds.setLow(-PlanarArm::kLimit_rad);
  bounds.setHigh(PlanarArm::kLimit_rad);
  const auto space = std::make_shared<ManipulationStateSpace>(bounds);
  const auto si = std::make_shared<ob::SpaceInformation>(space);
  const ReachGoal goal(si, std::make_shared<PlanarArm>(), ReachTargets::poses(kThreeGrasps));
  ob::ScopedState<ManipulationStateSpace> state(space);
  state->grasp = 3;
  goal.sampleGoal(state.get());
  EXPECT_EQ(state->grasp, kNoGrasp);
  EXPECT_TRUE(goal.isSatisfied(state.get()));
  state->grasp = 3;
  EXPECT_FALSE(goal.isSatisfied(state.get()));
}

TEST(GraspDeck, DrawsEachGraspOnceARoundInChangingOrder) {
  GraspDeck deck(20);
  std::mt19937_64 random(1);
  std::vector<std::vector<GraspId>> rounds(3);
  for (std::size_t r = 0; r < rounds.size(); ++r) {
    for (int i = 0; i < 20; ++i) {
      rounds[r].push_back(deck.next(random));
      EXPECT_EQ(deck.roundsEnded(), r);
    }
    EXPECT_EQ(std::set<GraspId>(rounds[r].begin(), rounds[r].end()).size(), 20u);
  }
  EXPECT_NE(rounds[0], rounds[1]);
}

TEST(JacobianStep, MovesTheTcpByTheTwist) {
  const PlanarArm arm;
  const auto context = arm.makeContext();
  const Eigen::Vector3d q(0.3, 0.9, -0.4);
  const Eigen::Vector3d lower = Eigen::Vector3d::Constant(-2.9), upper = -lower;
  const TcpTwist twist{{0.01, -0.02, 0.0}, {0.0, 0.0, 0.03}};
  const Eigen::VectorXd dq = jacobianStep(context->jacobian(q.data()), twist, q, lower, upper);
  const Eigen::Vector3d to = q + dq;
  const Eigen::Isometry3d before = PlanarArm::tcpPose(q.data()), after = PlanarArm::tcpPose(to.data());
  EXPECT_LT((after.translation() - before.translation() - twist.linear).norm(), 2e-3);
  EXPECT_NEAR(dq.sum(), 0.03, 2e-3);
}

TEST(JacobianStep, StopsAJointAtItsLimitAndMovesTheOthersOn) {
  const PlanarArm arm;
  const auto context = arm.makeContext();
  const Eigen::Vector3d q(0.3, 0.9, -0.4);
  Eigen::Vector3d lower = Eigen::Vector3d::Constant(-2.9), upper = -lower;
  const TcpTwist twist{{-0.004, 0.0, 0.0}, Eigen::Vector3d::Zero()};
  const Eigen::VectorXd free = jacobianStep(context->jacobian(q.data()), twist, q, lower, upper);
  (free[0] > 0 ? upper[0] : lower[0]) = q[0];
  const Eigen::VectorXd held = jacobianStep(context->jacobian(q.data()), twist, q, lower, upper);
  EXPECT_EQ(held[0], 0.0);
  const Eigen::Vector3d to = q + held;
  const Eigen::Vector3d moved_by =
      PlanarArm::tcpPose(to.data()).translation() - PlanarArm::tcpPose(q.data()).translation();
  EXPECT_LT((moved_by - twist.linear).norm(), 5e-4);
}

TEST(JacobianDescent, IsInverseKinematicsInsideTheLimits) {
  const PlanarArm arm;
  const auto context = arm.makeContext();
  const ReachTargets targets = ReachTargets::poses(posesAt({1.2, 0.8}, {0.9}));
  const Eigen::Vector3d lower = Eigen::Vector3d::Constant(-2.9), upper = -lower;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> joint(-2.9, 2.9);
  int found = 0;
  for (int i = 0; i < 50; ++i) {
    Eigen::VectorXd q = Eigen::Vector3d(joint(random), joint(random), joint(random));
    if (!descendTo(0, targets, *context, lower, upper, q)) continue;
    ++found;
    EXPECT_TRUE(targets.within(0, PlanarArm::tcpPose(q.data())));
    EXPECT_LE(q.cwiseAbs().maxCoeff(), 2.9);
  }
  EXPECT_GT(found, 15);
}

TEST(JacobianDescent, EndsWhereItCannotReach) {
  const PlanarArm arm;
  const auto context = arm.makeContext();
  const ReachTargets targets = ReachTargets::positions({{5.0, 0.0, 0.0}});
  const Eigen::Vector3d lower = Eigen::Vector3d::Constant(-2.9), upper = -lower;
  Eigen::VectorXd q = Eigen::Vector3d(0.5, 0.5, 0.5);
  EXPECT_FALSE(descendTo(0, targets, *context, lower, upper, q));
}

TEST(ApproachTable, GivesTheNearestUntriedNode) {
  const ReachTargets targets = ReachTargets::positions({{0, 0, 0}, {10, 0, 0}}, 0.1);
  ApproachTable table(targets);
  std::mt19937_64 random(1);
  EXPECT_EQ(table.draw(random, false), kNoGrasp);
  std::deque<Node> nodes;
  const double x[] = {3.0, 1.0, 6.0, 2.0};
  for (std::size_t i = 0; i < 4; ++i) {
    nodes.emplace_back(nullptr, nullptr, nullptr);
    const Eigen::Isometry3d X_WT(Eigen::Translation3d(x[i], 0, 0));
    EXPECT_EQ(table.offer(&nodes[i], X_WT, i == 3 ? 0 : kNoGrasp), kNoGrasp);
  }
  EXPECT_EQ(table.take(0), &nodes[1]);
  EXPECT_EQ(table.take(0), &nodes[0]);  // the last one was steered to this grasp
  EXPECT_EQ(table.take(0), &nodes[2]);
  EXPECT_EQ(table.draw(random, false), 1);
  EXPECT_EQ(table.take(1), &nodes[2]);
  const Node there{nullptr, nullptr, nullptr};
  EXPECT_EQ(table.offer(&there, Eigen::Isometry3d(Eigen::Translation3d(10, 0, 0.05))), 1);
}

TEST(ApproachTable, WeightedDrawPrefersGraspsThatAreNear) {
  const ReachTargets targets = ReachTargets::positions({{0, 0, 0}, {11, 0, 0}}, 0.1);
  ApproachTable table(targets);
  const Node node{nullptr, nullptr, nullptr};
  table.offer(&node, Eigen::Isometry3d(Eigen::Translation3d(1.1, 0, 0)));  // 1 and 9.8 from the grasps
  std::mt19937_64 random(1);
  for (const bool weighted : {false, true}) {
    std::map<GraspId, int> drawn;
    for (int i = 0; i < 1000; ++i) ++drawn[table.draw(random, weighted)];
    EXPECT_NEAR(drawn[0], weighted ? 907 : 500, 60);
  }
}

}  // namespace
}  // namespace b4p::test
