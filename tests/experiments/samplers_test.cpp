// SPDX-License-Identifier: BSD-3-Clause
// Grasps hold the object the way their family says; placements lie in their region.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "experiments/samplers/grasp_sampler.h"
#include "experiments/samplers/placement_sampler.h"

namespace b4p::test {
namespace {

TEST(PolygonEdgeGrasps, FaceInwardFromTheMiddleOfEachEdge) {
  const std::vector<Eigen::Vector2d> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const PolygonEdgeGraspSampler sampler(square, 0.1);
  ASSERT_EQ(sampler.all().size(), 4u);
  const Eigen::Vector3d middles[] = {{1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}};
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Isometry3d& X_OT = sampler.all()[i].X_OT;
    const Eigen::Vector3d inward = (Eigen::Vector3d(1, 1, 0) - middles[i]).normalized();
    EXPECT_TRUE(X_OT.linear().col(2).isApprox(inward, 1e-12));
    EXPECT_TRUE(X_OT.translation().isApprox(middles[i] - 0.1 * inward, 1e-12));
    EXPECT_NEAR(X_OT.linear().determinant(), 1.0, 1e-12);
  }
}

TEST(BoxGrasps, CloseOnFacesThatFitAndKeepThePalmOutside) {
  const Eigen::Vector3d size(0.102, 0.060, 0.0835);
  constexpr double kDepth = 0.03, kGap = 0.002;
  const BoxGraspSampler sampler(size, kDepth, kGap, 0.08);
  std::mt19937_64 random(1);
  int straight = 0;
  constexpr int kDraws = 2000;
  for (int draw = 0; draw < kDraws; ++draw) {
    const Grasp grasp = sampler.sample(random);
    const Eigen::Matrix3d R = grasp.X_OT.linear();
    const Eigen::Vector3d p = grasp.X_OT.translation();
    EXPECT_NEAR(std::abs(R.col(1).y()), 1.0, 1e-12) << "only the thin side fits between the fingers";
    EXPECT_NEAR(R.determinant(), 1.0, 1e-9);
    EXPECT_NEAR(grasp.opening_m, 0.060 + 2.0 * kGap, 1e-12);
    EXPECT_TRUE((p.cwiseAbs() - size / 2.0).maxCoeff() <= 1e-12) << "the TCP lies inside the box";
    const double foremost = (size / 2.0).dot(R.col(2).cwiseAbs());
    EXPECT_LE(p.dot(R.col(2)) + foremost, kDepth + 1e-12);
    straight += R.col(2).cwiseAbs().maxCoeff() > 1.0 - 1e-12;
  }
  EXPECT_NEAR(straight / double(kDraws), 0.5, 0.06);
}

TEST(BoxGrasps, RefuseABoxThatFitsNowhere) {
  EXPECT_THROW(BoxGraspSampler({0.1, 0.1, 0.1}, 0.03, 0.002, 0.08), std::invalid_argument);
}

TEST(StickGrasps, StandAcrossTheStickWithItsAxisBetweenThePads) {
  const StickGrasps stick{0.6, 0.0125, 0.05, 0.015, 0.002};
  const StickGraspSampler sampler(stick, 0.08);
  std::mt19937_64 random(1);
  for (int draw = 0; draw < 2000; ++draw) {
    const Grasp grasp = sampler.sample(random);
    const Eigen::Matrix3d R = grasp.X_OT.linear();
    const Eigen::Vector3d p = grasp.X_OT.translation();
    EXPECT_NEAR(R.determinant(), 1.0, 1e-9);
    EXPECT_NEAR(R(2, 1), 0.0, 1e-12) << "the pads close across the stick";
    EXPECT_NEAR(R(2, 2), 0.0, 1e-12) << "the hand stands across the stick";
    EXPECT_NEAR(p.dot(R.col(1)), 0.0, 1e-12) << "both pads are as far from the axis";
    EXPECT_NEAR(p.dot(R.col(2)), 0.015 - 0.0125, 1e-12) << "the finger depth, from the near side";
    EXPECT_LE(std::abs(p.z()), 0.6 / 2.0 - 0.05);
    EXPECT_NEAR(grasp.opening_m, 2.0 * (0.0125 + 0.002), 1e-12);
  }
}

TEST(StickGrasps, AreUniformAlongAndAroundTheStick) {
  const StickGraspSampler sampler({0.6, 0.0125, 0.05, 0.0125, 0.002}, 0.08);
  std::mt19937_64 random(2);
  constexpr int kDraws = 8000, kBins = 8;
  std::vector<int> along(kBins), around(kBins), sides(2);
  for (int draw = 0; draw < kDraws; ++draw) {
    const Eigen::Isometry3d X_OT = sampler.sample(random).X_OT;
    const double angle = std::atan2(X_OT(1, 2), X_OT(0, 2));
    ++along.at(static_cast<std::size_t>((X_OT(2, 3) + 0.25) / 0.5 * kBins));
    ++around.at(static_cast<std::size_t>((angle / 3.14159265358979 + 1.0) / 2.0 * kBins * (1.0 - 1e-12)));
    ++sides.at(X_OT(2, 0) > 0.0 ? 1 : 0);
  }
  // Five standard deviations of a bin's count, which is binomial.
  for (const std::vector<int>& bins : {along, around})
    for (const int count : bins) EXPECT_NEAR(count, kDraws / kBins, 150);
  EXPECT_NEAR(sides[0], kDraws / 2, 225) << "either pad is on either side";
}

TEST(StickGrasps, RefuseAStickThatDoesNotFit) {
  EXPECT_THROW(StickGraspSampler({0.6, 0.04, 0.05, 0.0125, 0.002}, 0.08), std::invalid_argument);
  EXPECT_THROW(StickGraspSampler({0.6, 0.0125, 0.31, 0.0125, 0.002}, 0.08), std::invalid_argument);
  EXPECT_THROW(StickGraspSampler({0.6, 0.0125, 0.05, 0.03, 0.002}, 0.08), std::invalid_argument);
}

class Placements : public ::testing::Test {
 protected:
  static PlacementSource source() {
    PlacementSource source;
    source.min_m = {0.5, -0.1, 0.3};
    source.max_m = {0.7, 0.1, 0.3};
    source.upright = true;
    source.yaw_min_rad = -0.2;
    source.yaw_max_rad = 0.4;
    return source;
  }
};

TEST_F(Placements, LieInsideTheRegionUprightAndTurnedAsAsked) {
  constexpr double kMargin_m = 1e-3;
  const PlacementSampler sampler(source(), Eigen::Isometry3d::Identity(), kMargin_m, 0.0);
  std::mt19937_64 random(2);
  for (int draw = 0; draw < 1000; ++draw) {
    const Eigen::Isometry3d X_WO = sampler.sample(random);
    EXPECT_EQ(sampler.distance(X_WO), 0.0);
    EXPECT_GE(X_WO.translation().x(), 0.5 + kMargin_m);
    EXPECT_LE(X_WO.translation().x(), 0.7 - kMargin_m);
    EXPECT_EQ(X_WO.translation().z(), 0.3);
    const double yaw = std::atan2(X_WO.linear()(1, 0), X_WO.linear()(0, 0));
    EXPECT_GE(yaw, -0.2 - 1e-12);
    EXPECT_LE(yaw, 0.4 + 1e-12);
  }
}

TEST_F(Placements, UprightStandsALyingObjectUp) {
  Eigen::Isometry3d lying = Eigen::Isometry3d::Identity();
  lying.rotate(Eigen::AngleAxisd(1.2, Eigen::Vector3d(1, 2, 0).normalized()));
  const PlacementSampler sampler(source(), lying, 0.0, 0.0);
  std::mt19937_64 random(3);
  EXPECT_TRUE(sampler.sample(random).linear().col(2).isApprox(Eigen::Vector3d::UnitZ(), 1e-12));
}

TEST_F(Placements, DistanceCountsMetresOutsideAndTilt) {
  const PlacementSampler sampler(source(), Eigen::Isometry3d::Identity(), 0.0, 1e-3);
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();
  X_WO.translation() = Eigen::Vector3d(0.6, 0.0, 0.35);
  EXPECT_NEAR(sampler.distance(X_WO), 0.05, 1e-12);
  X_WO.rotate(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()));
  EXPECT_NEAR(sampler.distance(X_WO), 0.05 + 0.3 - 1e-3, 1e-12);
}

}  // namespace
}  // namespace b4p::test
