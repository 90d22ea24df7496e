// SPDX-License-Identifier: BSD-3-Clause
// Promises of Retreat: a step moves the TCP by its length in the direction it names, turns nothing, keeps the
// joint limits and stays near.
#include "experiments/retreat.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "experiments/problem.h"

namespace b4p {
namespace {

constexpr double kStep_m = 0.04;

struct StickHand {
  Problem problem = makeProblem(loadScene("stick"));
  std::shared_ptr<const CollisionChecker> checker =
      FloatingBody::makeChecker(problem.checker->problem(), FloatingBody::Parts::kGripper, *problem.checker);
  FloatingBody hand{*checker};
};

TEST(Retreat, StepsAreStraightAndTurnNothing) {
  StickHand stick;
  const auto& robot = stick.problem.robot;
  Retreat retreat(robot, stick.hand);
  std::mt19937 random(3);
  int answered = 0;
  for (int posture = 0; posture < 50; ++posture) {
    Eigen::VectorXd q(robot->dof()), next(robot->dof());
    for (int i = 0; i < q.size(); ++i)
      q[i] = std::uniform_real_distribution<double>(robot->lower()[i], robot->upper()[i])(random);
    const Eigen::Isometry3d from = robot->tcpPose(q.data());
    for (int direction = 0; direction < Retreat::kDirections; ++direction) {
      if (!retreat.step(q.data(), direction, next.data())) continue;
      ++answered;
      const Eigen::Isometry3d to = robot->tcpPose(next.data());
      const Eigen::Vector3d way = to.translation() - from.translation();
      EXPECT_NEAR(way.norm(), kStep_m, 2e-4);
      EXPECT_TRUE(to.linear().isApprox(from.linear(), 2e-3));
      EXPECT_TRUE(robot->withinLimits(next.data()));
      EXPECT_LE((next - q).lpNorm<Eigen::Infinity>(), 0.5);
    }
  }
  EXPECT_GT(answered, 50 * Retreat::kDirections / 2);
}

TEST(Retreat, KnowsTheHandsAxesAndAllNeighboursOfACube) {
  StickHand stick;
  const auto& robot = stick.problem.robot;
  Retreat retreat(robot, stick.hand);
  // A posture well inside the workspace, from which every direction has an answer.
  const Eigen::VectorXd q = (Eigen::VectorXd(7) << 0.3, -0.5, 0.2, -2.2, 0.4, 1.9, 0.6).finished();
  const Eigen::Isometry3d from = robot->tcpPose(q.data());
  Eigen::VectorXd next(7);
  std::vector<Eigen::Vector3d> ways;
  for (int direction = 0; direction < Retreat::kDirections; ++direction) {
    ASSERT_TRUE(retreat.step(q.data(), direction, next.data())) << direction;
    ways.push_back((robot->tcpPose(next.data()).translation() - from.translation()).normalized());
  }
  const auto knows = [&](const Eigen::Vector3d& way) {
    return std::any_of(ways.begin(), ways.end(),
                       [&](const Eigen::Vector3d& known) { return known.dot(way.normalized()) > 0.9999; });
  };
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) EXPECT_TRUE(knows(sign * from.linear().col(axis)));
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        EXPECT_TRUE((x == 0 && y == 0 && z == 0) || knows(Eigen::Vector3d(x, y, z)));
}

}  // namespace
}  // namespace b4p
