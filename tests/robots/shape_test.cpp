// SPDX-License-Identifier: BSD-3-Clause
#include "robots/shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "robots/shipped_robot.h"

// Promises: the distances bound, and where stated equal, those of densely sampled surfaces; every size that
// is out of range is named with its value.

namespace b4p {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Eigen::Vector3d randomDirection(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
}

std::shared_ptr<const ConvexMesh> someMesh() {
  return convexHull({{0, 0, 0}, {0.3, 0, 0}, {0, 0.2, 0}, {0, 0, 0.5}, {0.2, 0.2, 0.3}});
}

/// The point of the shape, in S, that lies farthest in a direction.
struct Support {
  const Eigen::Vector3d& direction;

  Eigen::Vector3d operator()(const Box& box) const {
    return direction.cwiseSign().cwiseProduct(box.size) / 2.0;
  }
  Eigen::Vector3d operator()(const Sphere& sphere) const { return sphere.radius * direction; }
  Eigen::Vector3d operator()(const Cylinder& cylinder) const {
    const Eigen::Vector2d across = direction.head<2>().normalized() * cylinder.radius;
    return {across.x(), across.y(), std::copysign(cylinder.length / 2.0, direction.z())};
  }
  Eigen::Vector3d operator()(const Capsule& capsule) const {
    return Eigen::Vector3d(0, 0, std::copysign(capsule.length / 2.0, direction.z())) +
           capsule.radius * direction;
  }
  Eigen::Vector3d operator()(const std::shared_ptr<const ConvexMesh>& mesh) const {
    Eigen::Vector3d best = mesh->vertices.front();
    for (const auto& vertex : mesh->vertices)
      if (direction.dot(vertex) > direction.dot(best)) best = vertex;
    return best;
  }
};

/// Points on the surface in B, among them all that can be extreme.
std::vector<Eigen::Vector3d> surface(const PlacedShape& placed, std::mt19937_64& random) {
  constexpr int kPoints = 60000;
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < kPoints; ++i) {
    const Eigen::Vector3d direction = randomDirection(random);
    points.push_back(placed.X_BS * std::visit(Support{direction}, placed.shape));
  }
  return points;
}

struct NamedShape {
  const char* name;
  Shape shape;
  bool line_distance_exact;
};

class ShapeDistance : public testing::TestWithParam<NamedShape> {
 protected:
  PlacedShape placed_{GetParam().shape, unevenPose()};
  std::mt19937_64 random_{7};
};

TEST_P(ShapeDistance, FromPointEqualsThatOfTheSurface) {
  const auto points = surface(placed_, random_);
  for (int i = 0; i < 10; ++i) {
    const Eigen::Vector3d p = unevenPose().translation() + (i == 0 ? 0.0 : 0.8) * randomDirection(random_);
    double farthest = 0.0;
    for (const auto& x : points) farthest = std::max(farthest, (x - p).norm());
    EXPECT_LE(farthest, farthestDistance(placed_, p) + 1e-12);
    EXPECT_NEAR(farthest, farthestDistance(placed_, p), 1e-3);
  }
}

TEST_P(ShapeDistance, FromLineBoundsThatOfTheSurface) {
  const auto points = surface(placed_, random_);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d p = unevenPose().translation() + 0.5 * randomDirection(random_);
    const Eigen::Vector3d u =
        i == 0 ? Eigen::Vector3d(placed_.X_BS.linear().col(2)) : randomDirection(random_);
    double farthest = 0.0;
    for (const auto& x : points) farthest = std::max(farthest, u.cross(x - p).norm());
    const double bound = farthestDistanceFromLine(placed_, p, u);
    EXPECT_LE(farthest, bound + 1e-12);
    // A cylinder along the line is exact as well.
    if (GetParam().line_distance_exact || i == 0)
      EXPECT_NEAR(farthest, bound, 1e-3);
    else
      EXPECT_LE(bound, 1.2 * farthest);
  }
}

INSTANTIATE_TEST_SUITE_P(AllShapes, ShapeDistance,
                         testing::Values(NamedShape{"Box", Box{{0.3, 0.5, 0.2}}, true},
                                         NamedShape{"Sphere", Sphere{0.2}, true},
                                         NamedShape{"Cylinder", Cylinder{0.2, 0.5}, false},
                                         NamedShape{"FlatCylinder", Cylinder{0.4, 0.02}, false},
                                         NamedShape{"Capsule", Capsule{0.1, 0.6}, true},
                                         NamedShape{"RoundCapsule", Capsule{0.2, 0.0}, true},
                                         NamedShape{"Mesh", someMesh(), true}),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(ShapeProblem, GoodShapesHaveNone) {
  const std::vector<Shape> shapes{Box{{1, 2, 3}}, Sphere{1}, Cylinder{1, 2}, Capsule{1, 0}, someMesh()};
  for (const Shape& shape : shapes) EXPECT_EQ(shapeProblem(shape), "");
}

TEST(ShapeProblem, NamesSizeAndValue) {
  EXPECT_EQ(shapeProblem(Box{{1, -2.5, 3}}), "box size has to be positive and finite, not -2.5");
  for (const double bad : {0.0, -1.0, kNan, kInfinity}) {
    EXPECT_NE(shapeProblem(Box{{1, 1, bad}}), "");
    EXPECT_NE(shapeProblem(Sphere{bad}), "");
    EXPECT_NE(shapeProblem(Cylinder{bad, 1}), "");
    EXPECT_NE(shapeProblem(Cylinder{1, bad}), "");
    EXPECT_NE(shapeProblem(Capsule{bad, 1}), "");
  }
  for (const double bad : {-1.0, kNan, kInfinity}) EXPECT_NE(shapeProblem(Capsule{1, bad}), "");
}

class MeshProblem : public testing::Test {
 protected:
  std::string problem() const { return shapeProblem(std::make_shared<const ConvexMesh>(mesh_)); }
  ConvexMesh mesh_ = *convexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.6, 0.6, 0.6}});
};

TEST_F(MeshProblem, FindsHoles) {
  mesh_.triangles.pop_back();
  EXPECT_EQ(problem(), "mesh is not closed");
}

TEST_F(MeshProblem, FindsTurnedTriangles) {
  std::swap(mesh_.triangles[0][0], mesh_.triangles[0][1]);
  EXPECT_EQ(problem(), "mesh is not closed");
}

TEST_F(MeshProblem, FindsMeshesInsideOut) {
  for (auto& triangle : mesh_.triangles) std::swap(triangle[0], triangle[1]);
  EXPECT_EQ(problem(), "mesh encloses no volume or is turned inside out");
}

TEST_F(MeshProblem, FindsDents) {
  for (auto& vertex : mesh_.vertices)
    if (vertex.x() == 0.6) vertex *= 0.5;  // behind the plane through the three unit points
  EXPECT_NE(problem().find("mesh is not convex"), std::string::npos) << problem();
}

TEST_F(MeshProblem, FindsCornersThatDoNotExist) {
  mesh_.triangles[0][0] = 99;
  EXPECT_NE(problem(), "");
}

TEST_F(MeshProblem, FindsNonFiniteVerticesAndMissingMeshes) {
  mesh_.vertices[0].x() = kNan;
  EXPECT_NE(problem(), "");
  EXPECT_NE(shapeProblem(std::shared_ptr<const ConvexMesh>()), "");
  EXPECT_NE(shapeProblem(std::make_shared<const ConvexMesh>()), "");
}

}  // namespace
}  // namespace b4p
