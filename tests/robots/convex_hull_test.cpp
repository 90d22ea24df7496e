// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "robots/shape.h"

// Promises: the hull is a good mesh, contains all points, uses only given points; points without volume are
// refused.

namespace b4p {
namespace {

using Points = std::vector<Eigen::Vector3d>;

double volume(const ConvexMesh& mesh) {
  double sixfold = 0.0;
  for (const auto& t : mesh.triangles) {
    const auto v = [&](int i) {
      return mesh.vertices[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])];
    };
    sixfold += v(0).dot(v(1).cross(v(2)));
  }
  return sixfold / 6.0;
}

void expectHullOf(const ConvexMesh& hull, const Points& points) {
  EXPECT_EQ(shapeProblem(std::make_shared<const ConvexMesh>(hull)), "");
  for (const auto& vertex : hull.vertices)
    EXPECT_NE(std::find(points.begin(), points.end(), vertex), points.end()) << vertex.transpose();
  // A larger set has a larger hull: with all points added as candidates the mesh check finds any that stick
  // out.
  ConvexMesh with_all = hull;
  with_all.vertices.insert(with_all.vertices.end(), points.begin(), points.end());
  EXPECT_EQ(shapeProblem(std::make_shared<const ConvexMesh>(with_all)), "");
}

Points grid(int n, double spacing) {
  Points points;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z) points.emplace_back(spacing * Eigen::Vector3d(x, y, z));
  return points;
}

TEST(ConvexHull, OfACubeKeepsItsCornersOnly) {
  Points points = grid(2, 1.0);
  points.emplace_back(0.5, 0.5, 0.5);
  const auto hull = convexHull(points);
  EXPECT_EQ(hull->vertices.size(), 8u);
  EXPECT_EQ(hull->triangles.size(), 12u);
  EXPECT_NEAR(volume(*hull), 1.0, 1e-12);
  expectHullOf(*hull, points);
}

TEST(ConvexHull, OfAGridWithManyCoplanarPointsIsClosedAndConvex) {
  for (const double spacing : {1e-3, 0.1, 0.3}) {
    const Points points = grid(6, spacing);
    const auto hull = convexHull(points);
    EXPECT_NEAR(volume(*hull), std::pow(5 * spacing, 3), 1e-9 * std::pow(5 * spacing, 3));
    expectHullOf(*hull, points);
  }
}

TEST(ConvexHull, OfRepeatedPointsIsThatOfOne) {
  Points points = grid(2, 0.05);
  for (int i = 0; i < 3; ++i) points.insert(points.end(), points.begin(), points.begin() + 8);
  EXPECT_EQ(convexHull(points)->vertices.size(), 8u);
}

TEST(ConvexHull, OfRandomCloudsContainsThem) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (int cloud = 0; cloud < 50; ++cloud) {
    Points points;
    for (int i = 0; i < 4 + 10 * cloud; ++i)
      points.emplace_back(0.1 * Eigen::Vector3d(normal(random), normal(random), 0.1 * normal(random)));
    expectHullOf(*convexHull(points), points);
  }
}

TEST(ConvexHull, OfARoundCylinderIsClosedAndConvex) {
  Points points;
  for (int i = 0; i < 100; ++i)
    for (const double z : {0.0, 0.2, 0.4})
      points.emplace_back(0.05 * std::cos(0.0628318 * i), 0.05 * std::sin(0.0628318 * i), z);
  expectHullOf(*convexHull(points), points);
}

TEST(ConvexHull, RefusesPointsWithoutVolume) {
  EXPECT_THROW(convexHull({}), std::invalid_argument);
  EXPECT_THROW(convexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), std::invalid_argument);
  EXPECT_THROW(convexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.3, 0.2, 0}}),
               std::invalid_argument);
  EXPECT_THROW(convexHull(Points(20, Eigen::Vector3d(1, 2, 3))), std::invalid_argument);
  EXPECT_THROW(convexHull({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4}}), std::invalid_argument);
}

TEST(ConvexHull, RefusesNonFinitePoints) {
  Points points = grid(2, 1.0);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    points[3].y() = bad;
    EXPECT_THROW(convexHull(points), std::invalid_argument);
  }
}

}  // namespace
}  // namespace b4p
