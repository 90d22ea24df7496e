// SPDX-License-Identifier: BSD-3-Clause
// What a placement is verified by, on solids whose distances are known.
#include <cmath>

#include <gtest/gtest.h>

#include "experiments/scene.h"
#include "experiments/verification/clearance.h"
#include "experiments/verification/footing.h"

namespace b4p {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using verification::Clearance;
using verification::Footing;

Obstacle box(const std::string& name, const Vector3d& size, const Vector3d& centre) {
  return {name, {Box{size}, Isometry3d(Eigen::Translation3d(centre))}};
}

/// A floor of 2 m x 2 m with its top at z = 0, a volume of 2 m x 2 m x 1 m on it, and a cube of 0.1 m whose
/// centre is O.
Scene onTheFloor() {
  Scene scene;
  scene.obstacles.push_back(box("floor", {2.0, 2.0, 0.1}, {0.0, 0.0, -0.05}));
  scene.task = PlacementTask{};
  scene.placing().object.push_back({Box{Vector3d::Constant(0.1)}, Isometry3d::Identity()});
  scene.placing().min_m = {-1.0, -1.0, 0.0};
  scene.placing().max_m = {1.0, 1.0, 1.0};
  scene.placing().cell_m = 0.005;
  return scene;
}

Isometry3d at(double x, double y, double z) { return Isometry3d(Eigen::Translation3d(x, y, z)); }

std::string footing(const Scene& scene, const Isometry3d& X_WO) {
  double gap_m = 0.0;
  return Footing(scene).problem(X_WO, gap_m);
}

TEST(Footing, CubeStandsALittleAboveTheFloor) {
  const Scene scene = onTheFloor();
  double gap_m = 0.0;
  EXPECT_EQ(Footing(scene).problem(at(0.3, 0.2, 0.053), gap_m), "");
  EXPECT_NEAR(gap_m, 0.003, 1e-5);
}

TEST(Footing, NothingStandsInTheAir) {
  EXPECT_NE(footing(onTheFloor(), at(0.3, 0.2, 0.06)).find("nothing carries"), std::string::npos);
}

TEST(Footing, EveryFootIsCarried) {
  Scene scene = onTheFloor();
  scene.obstacles = {box("left", {0.2, 1.0, 0.1}, {-0.13, 0.0, -0.05})};
  EXPECT_NE(footing(scene, at(0.0, 0.0, 0.053)).find("nothing carries"), std::string::npos);
  scene.obstacles.push_back(box("right", {0.2, 1.0, 0.1}, {0.13, 0.0, -0.05}));
  EXPECT_EQ(footing(scene, at(0.0, 0.0, 0.053)), "") << "it bridges the gap between the two";
}

TEST(Footing, FeetAreInsideTheVolume) {
  Scene scene = onTheFloor();
  scene.placing().max_m.x() = 0.3;
  EXPECT_EQ(footing(scene, at(0.249, 0.0, 0.053)), "");
  EXPECT_NE(footing(scene, at(0.27, 0.0, 0.053)).find("outside the target volume"), std::string::npos);
}

TEST(Footing, CentreOfMassIsAboveTheFeet) {
  Scene scene = onTheFloor();
  scene.placing().p_OCom = {0.041, 0.0, 0.0};
  EXPECT_EQ(footing(scene, at(0.0, 0.0, 0.053)), "");
  scene.placing().p_OCom = {0.043, 0.0, 0.0};
  EXPECT_NE(footing(scene, at(0.0, 0.0, 0.053)).find("centre of mass"), std::string::npos);
}

TEST(Footing, EdgeIsNoFooting) {
  for (const double yaw : {0.0, 0.123}) {
    Isometry3d X_WO = at(0.0, 0.0, 0.05 * std::sqrt(2.0) + 0.003);
    X_WO.rotate(Eigen::AngleAxisd(yaw, Vector3d::UnitZ()));
    X_WO.rotate(Eigen::AngleAxisd(std::acos(-1.0) / 4.0, Vector3d::UnitX()));
    EXPECT_NE(footing(onTheFloor(), X_WO).find("centre of mass"), std::string::npos) << yaw;
  }
}

TEST(Footing, FaceMayTiltByALittle) {
  for (const auto& [tilt, stands] : {std::pair{0.009, true}, std::pair{0.02, false}}) {
    Isometry3d X_WO = at(0.0, 0.0, 0.053);
    X_WO.rotate(Eigen::AngleAxisd(tilt, Vector3d::UnitX()));
    EXPECT_EQ(footing(onTheFloor(), X_WO).empty(), stands) << tilt;
  }
}

TEST(Footing, CylinderStandsOnItsEnd) {
  Scene scene = onTheFloor();
  scene.placing().object = {{Cylinder{0.03, 0.2}, Isometry3d::Identity()}};
  EXPECT_EQ(footing(scene, at(0.0, 0.0, 0.103)), "");
  EXPECT_NE(footing(scene, at(0.98, 0.0, 0.103)), "") << "part of its rim is beside the floor";
}

TEST(Footing, CylinderOnItsSideRolls) {
  Scene scene = onTheFloor();
  Isometry3d lying = at(0.0, 0.0, 0.0);
  lying.rotate(Eigen::AngleAxisd(0.4, Vector3d::UnitZ()) *
               Eigen::AngleAxisd(std::acos(-1.0) / 2.0, Vector3d::UnitX()));
  for (const double radius : {0.01, 0.03, 0.3}) {
    scene.placing().object = {{Cylinder{radius, 0.2}, Isometry3d::Identity()}};
    const Isometry3d X_WO = at(0.0, 0.0, radius + 0.003) * lying;
    EXPECT_NE(footing(scene, X_WO).find("centre of mass"), std::string::npos) << radius;
  }
  scene.placing().object = {{Cylinder{0.03, 0.2}, at(-0.05, 0.0, 0.0)},
                            {Cylinder{0.03, 0.2}, at(0.05, 0.0, 0.0)}};
  EXPECT_EQ(footing(scene, at(0.0, 0.0, 0.033) * lying), "") << "two side by side are a sledge";
}

TEST(Clearance, WallsCountAndTheFloorDoesNot) {
  Scene scene = onTheFloor();
  scene.obstacles.push_back(box("wall", {0.1, 2.0, 1.0}, {0.55, 0.0, 0.5}));
  const Clearance clearance(scene);
  EXPECT_NEAR(clearance.at({0.0, 0.3, 0.01}), 0.5, 1e-6);
  EXPECT_NEAR(clearance.at({0.4, 0.0, 0.7}), 0.1, 1e-6);
  EXPECT_EQ(clearance.at({0.55, 0.0, 0.5}), 0.0);
}

TEST(Clearance, WithoutObstaclesItIsTheDiagonal) {
  EXPECT_NEAR(Clearance(onTheFloor()).at({0.0, 0.0, 0.1}), std::sqrt(9.0), 1e-9);
}

TEST(Clearance, WhatIsAboveCountsAndWhatIsLowerDoesNot) {
  Scene scene = onTheFloor();
  scene.obstacles.push_back(box("shelf", {0.4, 0.4, 0.1}, {0.0, 0.0, 0.65}));
  scene.obstacles.push_back(box("step", {0.2, 0.2, 0.2}, {0.3, 0.0, 0.1}));
  const Clearance clearance(scene);
  EXPECT_NEAR(clearance.at({0.0, 0.0, 0.3}), 0.3, 1e-6) << "the step's top is at 0.2";
  EXPECT_NEAR(clearance.at({0.0, 0.0, 0.1}), 0.2, 1e-6) << "the step";
}

TEST(Clearance, OnlyThePartThatIsNotLowerCounts) {
  Scene scene = onTheFloor();
  scene.obstacles.push_back({"ball", {Sphere{0.3}, at(0.0, 0.0, 0.3)}});
  const double at_height = std::sqrt(0.3 * 0.3 - 0.2 * 0.2);  // radius of the ball's section at z = 0.5
  EXPECT_NEAR(Clearance(scene).at({0.6, 0.0, 0.5}), 0.6 - at_height, 2e-3);
}

TEST(Clearance, WhatIsOutsideOfTheVolumeDoesNotCount) {
  Scene scene = onTheFloor();
  scene.obstacles.push_back(box("beyond", {0.1, 2.0, 1.0}, {1.1, 0.0, 0.5}));
  scene.obstacles.push_back(box("sideways", {0.1, 0.6, 1.0}, {0.0, 1.25, 0.5}));  // reaches in from y = 0.95
  const Clearance clearance(scene);
  EXPECT_NEAR(clearance.at({0.0, 0.5, 0.5}), 0.45, 1e-6);
  EXPECT_NEAR(clearance.at({0.9, 0.9, 0.5}), std::hypot(0.85, 0.05), 2e-3);
}

TEST(Clearance, PointsOutsideOfTheVolumeCountAsThoseAtItsBorder) {
  Scene scene = onTheFloor();
  scene.placing().max_m.z() = 0.4;
  scene.obstacles.push_back(box("tower", {0.2, 0.2, 0.45}, {0.0, 0.0, 0.225}));
  const Clearance clearance(scene);
  EXPECT_NEAR(clearance.at({0.5, 0.0, 0.39}), 0.4, 1e-6);
  EXPECT_NEAR(clearance.at({0.5, 0.0, 0.6}), 0.4, 1e-6) << "as at the top of the volume";
}

TEST(Clearance, OfAnObjectIsTheMeanOverItsPoints) {
  Scene scene = onTheFloor();
  scene.obstacles.push_back(box("wall", {0.1, 2.0, 1.0}, {0.55, 0.0, 0.5}));
  EXPECT_NEAR(Clearance(scene).mean_m(at(0.1, 0.0, 0.053)), 0.4, 1e-4);
}

}  // namespace
}  // namespace b4p
