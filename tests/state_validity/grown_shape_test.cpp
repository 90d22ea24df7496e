// SPDX-License-Identifier: BSD-3-Clause
// Grown shapes contain everything within the padding, and not much more.
#include <gtest/gtest.h>

#include "state_validity/grown_mesh.h"
#include "state_validity/grown_shape.h"
#include "state_validity/shape_bounds.h"
#include "tests/state_validity/crane.h"

namespace b4p::testing {
namespace {

Eigen::Vector3d randomDirection(std::mt19937_64& random) {
  std::normal_distribution<> normal;
  return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
}

// A convex shape contains another exactly if it extends at least as far in all directions.
void expectGrown(const Shape& shape, double padding_m, double most) {
  const Shape grown = grownShape(shape, padding_m);
  ASSERT_EQ(shapeProblem(grown), "");
  std::mt19937_64 random(30);
  double widest = 0.0;
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector3d u = randomDirection(random);
    const double growth = extentAlong({grown, Eigen::Isometry3d::Identity()}, u) -
                          extentAlong({shape, Eigen::Isometry3d::Identity()}, u);
    ASSERT_GE(growth, padding_m - 1e-9) << u.transpose();
    widest = std::max(widest, growth);
  }
  EXPECT_LE(widest, most * padding_m);
}

TEST(GrownShape, ContainsThePaddingAroundEveryShape) {
  for (const NamedShape& named : oneOfEach()) {
    SCOPED_TRACE(named.name);
    expectGrown(named.shape, 0.005, 1.75);
  }
}

TEST(GrownShape, ContainsThePaddingAroundMeshesOfAllKinds) {
  std::mt19937_64 random(31);
  std::uniform_real_distribution<> size(0.01, 0.3);
  for (int i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    const Eigen::Vector3d stretch(size(random), size(random), size(random)), shift = randomDirection(random);
    std::vector<Eigen::Vector3d> points;
    for (int k = 0; k < 4 + i; ++k) points.push_back(shift + randomDirection(random).cwiseProduct(stretch));
    // Acute corners keep spikes, hence no bound of how far the result may reach.
    expectGrown(convexHull(points), 0.005, 1e3);
  }
}

TEST(GrownShape, OfAPrismIsTightOnSlantedFaces) {
  // A triangular prism, as a polygon in the plane becomes.
  const std::shared_ptr<const ConvexMesh> prism = convexHull({{0.0, 0.0, -0.1},
                                                              {0.3, 0.0, -0.1},
                                                              {0.1, 0.2, -0.1},
                                                              {0.0, 0.0, 0.1},
                                                              {0.3, 0.0, 0.1},
                                                              {0.1, 0.2, 0.1}});
  const Shape grown = grownShape(prism, 0.01);
  for (const Eigen::Vector3d& across : {Eigen::Vector3d(1.0, 1.0, 0.0), Eigen::Vector3d(-2.0, 1.0, 0.0),
                                        Eigen::Vector3d(0.0, -1.0, 0.0), Eigen::Vector3d(0.0, 0.0, 1.0)}) {
    const Eigen::Vector3d u = across.normalized();
    EXPECT_NEAR(extentAlong({grown, Eigen::Isometry3d::Identity()}, u),
                extentAlong({prism, Eigen::Isometry3d::Identity()}, u) + 0.01, 1e-9);
  }
}

TEST(ShapeBounds, ContainTheShapeInAnyPose) {
  std::mt19937_64 random(32);
  for (const NamedShape& named : oneOfEach())
    for (int i = 0; i < 200; ++i) {
      PlacedShape placed = placedAt(named.shape, randomDirection(random));
      placed.X_BS.rotate(Eigen::AngleAxisd(3.0 * randomDirection(random).x(), randomDirection(random)));
      const Aabb aabb = boundsOf(named.shape).posed(placed.X_BS).aabb();
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d u = Eigen::Vector3d::Unit(axis);
        EXPECT_LE(extentAlong(placed, u), aabb.centre[axis] + aabb.half[axis] + 1e-12) << named.name;
        EXPECT_LE(extentAlong(placed, -u), -aabb.centre[axis] + aabb.half[axis] + 1e-12) << named.name;
      }
    }
}

}  // namespace
}  // namespace b4p::testing
