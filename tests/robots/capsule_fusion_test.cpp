// SPDX-License-Identifier: BSD-3-Clause
#include "robots/capsule_fusion.h"

#include <gtest/gtest.h>

#include "robots/shipped_robot.h"

// Promises: a cylinder with its two end spheres becomes one capsule in the same place; nothing else changes.

namespace b4p {
namespace {

constexpr double kRadius = 0.07, kLength = 0.3;

PlacedShape sphereAt(double z, double radius = kRadius) {
  PlacedShape sphere{Sphere{radius}, unevenPose()};
  sphere.X_BS.translate(Eigen::Vector3d(0, 0, z));
  return sphere;
}

const PlacedShape kCylinder{Cylinder{kRadius, kLength}, unevenPose()};

TEST(CapsuleFusion, CylinderWithTwoEndSpheresBecomesACapsule) {
  std::vector<PlacedShape> shapes{
      sphereAt(kLength / 2), {Box{{1, 1, 1}}, {}}, kCylinder, sphereAt(-kLength / 2)};
  fuseCapsules(shapes);
  ASSERT_EQ(shapes.size(), 2u);
  EXPECT_TRUE(std::holds_alternative<Box>(shapes[0].shape));
  const auto* capsule = std::get_if<Capsule>(&shapes[1].shape);
  ASSERT_NE(capsule, nullptr);
  EXPECT_EQ(capsule->radius, kRadius);
  EXPECT_EQ(capsule->length, kLength);
  EXPECT_TRUE(shapes[1].X_BS.isApprox(unevenPose()));
}

TEST(CapsuleFusion, OtherCombinationsStay) {
  const std::vector<std::vector<PlacedShape>> combinations{
      {kCylinder},
      {kCylinder, sphereAt(kLength / 2)},
      {kCylinder, sphereAt(kLength / 2), sphereAt(kLength / 2)},
      {kCylinder, sphereAt(kLength / 2), sphereAt(-kLength / 2 + 0.01)},
      {kCylinder, sphereAt(kLength / 2), sphereAt(-kLength / 2, 0.05)}};
  for (auto shapes : combinations) {
    const std::size_t before = shapes.size();
    fuseCapsules(shapes);
    EXPECT_EQ(shapes.size(), before);
    for (const auto& placed : shapes) EXPECT_FALSE(std::holds_alternative<Capsule>(placed.shape));
  }
}

TEST(CapsuleFusion, ASphereServesOneCapsuleOnly) {
  PlacedShape next = kCylinder;
  next.X_BS.translate(Eigen::Vector3d(0, 0, kLength));
  std::vector<PlacedShape> shapes{kCylinder, next, sphereAt(-kLength / 2), sphereAt(kLength / 2),
                                  sphereAt(1.5 * kLength)};
  fuseCapsules(shapes);
  ASSERT_EQ(shapes.size(), 3u);
  EXPECT_TRUE(std::holds_alternative<Capsule>(shapes[0].shape));
  EXPECT_TRUE(std::holds_alternative<Cylinder>(shapes[1].shape));
}

}  // namespace
}  // namespace b4p
