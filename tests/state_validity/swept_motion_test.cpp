// SPDX-License-Identifier: BSD-3-Clause
// The bound of swept motion holds for points of all shapes, and is not uselessly loose.
#include <cmath>

#include <gtest/gtest.h>

#include "state_validity/swept_motion.h"
#include "tests/state_validity/crane.h"
#include "tests/state_validity/panda.h"

namespace b4p::testing {
namespace {

// Points of a box's surface, its corners included.
std::vector<Eigen::Vector3d> pointsOf(const PlacedShape& placed, std::mt19937_64& random) {
  std::vector<Eigen::Vector3d> points;
  std::uniform_real_distribution<> unit(-1.0, 1.0);
  for (int i = 0; i < 12; ++i) {
    Eigen::Vector3d direction(unit(random), unit(random), unit(random));
    direction.normalize();
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    if (const auto* box = std::get_if<Box>(&placed.shape))
      p = direction.cwiseSign().cwiseProduct(0.5 * box->size);
    if (const auto* sphere = std::get_if<Sphere>(&placed.shape)) p = sphere->radius * direction;
    if (const auto* capsule = std::get_if<Capsule>(&placed.shape))
      p = capsule->radius * direction +
          Eigen::Vector3d(0.0, 0.0, std::copysign(0.5 * capsule->length, direction.z()));
    points.push_back(placed.X_BS * p);
  }
  return points;
}

TEST(SweptMotion, BoundsEveryPointOfThePandaAndOfWhatItHolds) {
  const Manipulator& robot = *panda();
  const RobotModel& model = robot.model();
  const Grasp grasp = pandaGrasp();
  std::mt19937_64 random(20);
  std::vector<Eigen::Isometry3d> X1, X2;
  double tightest = 0.0;
  const auto checkLink = [&](int link, const PlacedShape& shape) {
    const Eigen::VectorXd travel = travelPerUnit(robot, link, shape);
    for (int i = 0; i < 400; ++i) {
      const PandaConfiguration q1 = randomPanda(random);
      PandaConfiguration q2 = randomPanda(random);
      const auto only = static_cast<std::size_t>(i % 8);  // one joint alone, or (7) all of them
      double bound = 0.0;
      for (std::size_t j = 0; j < q2.size(); ++j) {
        q2[j] = only < 7 && j != only ? q1[j] : q1[j] + 0.02 * (q2[j] - q1[j]);
        bound += travel[static_cast<Eigen::Index>(j)] * std::abs(q2[j] - q1[j]);
      }
      robot.linkPoses(q1.data(), 0.08 * (i % 3) / 2.0, X1);
      robot.linkPoses(q2.data(), 0.08 * (i % 3) / 2.0, X2);
      const auto l = static_cast<std::size_t>(link);
      for (const Eigen::Vector3d& p : pointsOf(shape, random)) {
        const double moved = (X2[l] * p - X1[l] * p).norm();
        ASSERT_LE(moved, bound + 1e-12) << model.links[l].name;
        if (bound > 0.0) tightest = std::max(tightest, moved / bound);
      }
    }
  };
  for (std::size_t link = 0; link < model.links.size(); ++link)
    for (const PlacedShape& shape : model.links[link].shapes) checkLink(static_cast<int>(link), shape);
  checkLink(robot.tcpLink(), {Box{{0.06, 0.06, 0.12}}, grasp.X_OT.inverse()});
  EXPECT_GT(tightest, 0.95);
}

TEST(SweptMotion, OfSlidingJointsIsOneAndOfTurningOnesTheDistanceFromTheAxis) {
  const auto robot = Crane().with("tool", Sphere{0.1}).build();
  const int tool = robot->model().linkIndex("tool");
  EXPECT_TRUE(travelPerUnit(*robot, tool, placedAt(Sphere{0.1}, {0.5, 0.0, 2.0}))
                  .isApprox(Eigen::Vector4d(1.0, 1.0, 1.0, 0.6), 1e-12));
  EXPECT_TRUE(
      travelPerUnit(*robot, robot->model().linkIndex("bridge"), placedAt(Sphere{0.1}, {0.5, 0.0, 2.0}))
          .isApprox(Eigen::Vector4d(1.0, 1.0, 0.0, 0.0), 1e-12));
  // A finger is counted at the opening that takes it farthest: 0.1 m from the tool's axis.
  EXPECT_NEAR(
      travelPerUnit(*robot, robot->model().linkIndex("left"), placedAt(Sphere{0.01}, {0.0, 0.0, 0.0}))[3],
      0.11, 1e-12);
}

TEST(SweptMotion, IsNotMuchLooserThanThePandasReach) {
  const Eigen::VectorXd travel =
      travelPerUnit(*panda(), panda()->tcpLink(), placedAt(Sphere{0.01}, Eigen::Vector3d::Zero()));
  // The TCP reaches 0.86 m from the shoulder and about 0.23 m from the axis of joint 6; joint 7 does not move
  // it.
  EXPECT_LT(travel[0], 1.15);
  EXPECT_LT(travel[5], 0.26);
  EXPECT_NEAR(travel[6], 0.01, 1e-9);
}

}  // namespace
}  // namespace b4p::testing
