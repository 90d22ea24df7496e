// SPDX-License-Identifier: BSD-3-Clause
// Promises: distances equal closed forms; the direction proves the gap; contact, containment and touching are
// never called apart, whatever the pair of shapes.
#include "experiments/verification/separation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace b4p::verification {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr int kPoses = 5000;

class SeparationTest : public testing::Test {
 protected:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vector3d vector(double extent) {
    return {uniform(-extent, extent), uniform(-extent, extent), uniform(-extent, extent)};
  }
  Vector3d size() { return {uniform(0.01, 1), uniform(0.01, 1), uniform(0.01, 1)}; }
  Isometry3d pose(double extent) {
    std::normal_distribution<double> normal;
    const Eigen::Quaterniond turn(normal(random_), normal(random_), normal(random_), normal(random_));
    return Eigen::Translation3d(vector(extent)) * turn.normalized();
  }
  /// Any of the shapes, some of them thin plates and needles.
  ConvexBody anyBody() {
    const Vector3d s = size().cwiseProduct(Vector3d(1, 1, uniform(0, 1) < 0.3 ? 1e-3 : 1));
    switch (std::uniform_int_distribution<int>(0, 4)(random_)) {
      case 0:
        return ConvexBody::box(s);
      case 1:
        return ConvexBody::sphere(s.x());
      case 2:
        return ConvexBody::cylinder(s.x(), s.z());
      case 3:
        return ConvexBody::capsule(s.x(), s.z());
      default: {
        std::vector<Vector3d> points;
        for (int i = 0; i < 20; ++i) points.push_back(vector(1).cwiseProduct(s));
        return ConvexBody::hull(points);
      }
    }
  }
  /// Measures, and checks that the direction proves what is said.
  double distance(const ConvexBody& a, const Isometry3d& X_WA, const ConvexBody& b, const Isometry3d& X_WB) {
    const Separation found = separation(a, X_WA, b, X_WB, vector(1));
    EXPECT_NEAR(found.direction.norm(), 1.0, 1e-12);
    const auto extreme = [&](const ConvexBody& body, const Isometry3d& X, const Vector3d& direction) {
      return direction.dot(X * body.support(X.linear().transpose() * direction)) + body.margin();
    };
    const double gap = -extreme(a, X_WA, -found.direction) - extreme(b, X_WB, found.direction);
    EXPECT_NEAR(gap, found.distance_m, 1e-12);
    return found.distance_m;
  }
  void expectDistance(double found, double expected) {
    if (expected > 0.0) {
      EXPECT_NEAR(found, expected, 1e-7 * std::max(1.0, expected));
      ++apart_;
    } else {
      EXPECT_LE(found, kTouching_m);
    }
  }
  void TearDown() override {
    EXPECT_TRUE(apart_ == 0 || apart_ > kPoses / 10) << "the poses cover contact alone";
  }

  std::mt19937_64 random_{7};
  int apart_ = 0;
};

TEST_F(SeparationTest, SphereSphere) {
  for (int i = 0; i < kPoses; ++i) {
    const double r = uniform(0.01, 1), s = uniform(0.01, 1);
    const Isometry3d A = pose(1.5), B = pose(1.5);
    expectDistance(distance(ConvexBody::sphere(r), A, ConvexBody::sphere(s), B),
                   (A.translation() - B.translation()).norm() - r - s);
  }
}

TEST_F(SeparationTest, SphereBox) {
  for (int i = 0; i < kPoses; ++i) {
    const double r = uniform(0.01, 0.5);
    const Vector3d sides = size();
    const Isometry3d A = pose(1), B = pose(1);
    const Vector3d outside = (B.inverse() * A.translation()).cwiseAbs() - sides / 2;
    expectDistance(distance(ConvexBody::sphere(r), A, ConvexBody::box(sides), B),
                   outside.cwiseMax(0).norm() - r);
  }
}

TEST_F(SeparationTest, CylinderSphere) {
  for (int i = 0; i < kPoses; ++i) {
    const double r = uniform(0.01, 0.5), radius = uniform(0.01, 0.5), length = uniform(0.01, 1);
    const Isometry3d A = pose(1), B = pose(1);
    const Vector3d p = A.inverse() * B.translation();
    const double across = std::max(0.0, std::hypot(p.x(), p.y()) - radius);
    const double along = std::max(0.0, std::abs(p.z()) - length / 2);
    expectDistance(distance(ConvexBody::cylinder(radius, length), A, ConvexBody::sphere(r), B),
                   std::hypot(across, along) - r);
  }
}

TEST_F(SeparationTest, CapsuleSphere) {
  for (int i = 0; i < kPoses; ++i) {
    const double r = uniform(0.01, 0.3), radius = uniform(0.01, 0.3), length = uniform(0, 1);
    const Isometry3d A = pose(1), B = pose(1);
    const Vector3d p = A.inverse() * B.translation();
    const Vector3d on_axis(0, 0, std::clamp(p.z(), -length / 2, length / 2));
    expectDistance(distance(ConvexBody::capsule(radius, length), A, ConvexBody::sphere(r), B),
                   (p - on_axis).norm() - r - radius);
  }
}

TEST_F(SeparationTest, BoxBoxWithParallelSides) {
  for (int i = 0; i < kPoses; ++i) {
    const Vector3d a = size(), b = size(), shift = vector(1);
    const Isometry3d A = pose(1);
    const Vector3d gaps = shift.cwiseAbs() - (a + b) / 2;
    expectDistance(distance(ConvexBody::box(a), A, ConvexBody::box(b), A * Eigen::Translation3d(shift)),
                   gaps.cwiseMax(0).norm());
  }
}

// Two boxes are apart exactly when one of 15 axes says so.
TEST_F(SeparationTest, BoxBoxVerdictIsThatOfTheFifteenAxes) {
  for (int i = 0; i < 4 * kPoses; ++i) {
    const Vector3d a = size(), b = size();
    const Isometry3d A = pose(0.7), B = pose(0.7);
    std::vector<Vector3d> axes;
    for (int k = 0; k < 3; ++k) {
      axes.push_back(A.linear().col(k));
      axes.push_back(B.linear().col(k));
      for (int l = 0; l < 3; ++l) axes.push_back(A.linear().col(k).cross(B.linear().col(l)).normalized());
    }
    double widest = -1.0;
    for (const Vector3d& axis : axes) {
      const double reach = (A.linear().transpose() * axis).cwiseAbs().dot(a / 2) +
                           (B.linear().transpose() * axis).cwiseAbs().dot(b / 2);
      widest = std::max(widest, std::abs(axis.dot(A.translation() - B.translation())) - reach);
    }
    if (std::abs(widest) < 1e-7) continue;
    EXPECT_EQ(distance(ConvexBody::box(a), A, ConvexBody::box(b), B) > kTouching_m, widest > 0.0) << widest;
  }
}

TEST_F(SeparationTest, HullOfBoxCornersMeasuresLikeTheBox) {
  for (int i = 0; i < kPoses; ++i) {
    const Vector3d sides = size();
    std::vector<Vector3d> corners;
    for (int c = 0; c < 8; ++c)
      corners.push_back(
          sides.cwiseProduct(Vector3d(c & 1, c >> 1 & 1, c >> 2 & 1) - Vector3d::Constant(0.5)));
    const ConvexBody other = anyBody();
    const Isometry3d A = pose(1), B = pose(1);
    expectDistance(distance(ConvexBody::hull(corners), A, other, B),
                   std::max(0.0, distance(ConvexBody::box(sides), A, other, B)));
  }
}

// A point of each body at the same place: they meet, whatever they are. The points lie inside, or on the
// surface.
TEST_F(SeparationTest, BodiesThatShareAPointAreNeverApart) {
  for (int i = 0; i < 10 * kPoses; ++i) {
    const ConvexBody a = anyBody(), b = anyBody();
    const Isometry3d A = pose(1);
    Isometry3d B = pose(1);
    const double depth_a = i % 2 == 0 ? 1.0 : uniform(0, 1), depth_b = i % 2 == 0 ? 1.0 : uniform(0, 1);
    const Vector3d p_a = A * (depth_a * a.support(vector(1)) + (1 - depth_a) * a.support(vector(1)));
    const Vector3d p_b = B * (depth_b * b.support(vector(1)) + (1 - depth_b) * b.support(vector(1)));
    B.pretranslate(p_a - p_b);
    ASSERT_FALSE(separation(a, A, b, B, vector(1)).apart()) << i;
  }
}

TEST_F(SeparationTest, ASmallBodyInsideALargeOneIsNotApart) {
  for (int i = 0; i < kPoses; ++i) {
    const ConvexBody large = ConvexBody::box({3, 3, 3});
    const ConvexBody small = i % 3 == 0   ? ConvexBody::sphere(1e-3)
                             : i % 3 == 1 ? ConvexBody::cylinder(1e-3, 1e-3)
                                          : ConvexBody::box({1e-3, 1e-3, 1e-3});
    EXPECT_FALSE(separation(large, Isometry3d::Identity(), small, pose(1.4), vector(1)).apart());
    EXPECT_FALSE(separation(small, pose(1.4), large, Isometry3d::Identity(), vector(1)).apart());
  }
}

TEST_F(SeparationTest, ThinPlatesThatCrossAreNotAndThatFaceEachOtherAreApart) {
  const ConvexBody plate = ConvexBody::box({2, 2, 1e-6});
  for (int i = 0; i < kPoses; ++i) {
    const Isometry3d A = pose(1);
    Isometry3d crossing = pose(0);
    crossing.translation() = A * Vector3d(uniform(-0.9, 0.9), uniform(-0.9, 0.9), 0);
    EXPECT_FALSE(separation(plate, A, plate, crossing, vector(1)).apart());
    const double gap = uniform(1e-6, 1e-2);
    const Isometry3d facing = A * Eigen::Translation3d(uniform(-1, 1), uniform(-1, 1), gap + 1e-6);
    EXPECT_NEAR(distance(plate, A, plate, facing), gap, 1e-9);
  }
}

// Moving one body towards the other along the gap takes exactly that much from the distance.
TEST_F(SeparationTest, NarrowGapsAreMeasuredToo) {
  for (int i = 0; i < 4 * kPoses; ++i) {
    const ConvexBody a = anyBody(), b = anyBody();
    const Isometry3d A = pose(2), B = pose(2);
    const Separation wide = separation(a, A, b, B, vector(1));
    if (!wide.apart()) continue;
    const double gap = std::pow(10.0, uniform(-6, -2));
    const Isometry3d nearer = Eigen::Translation3d(-(wide.distance_m - gap) * wide.direction) * A;
    const double found = distance(a, nearer, b, B);
    EXPECT_GE(found, 0.9 * gap) << i;
    EXPECT_LE(found, gap + 1e-5) << i;  // `wide` may have fallen short by its accuracy
  }
}

TEST_F(SeparationTest, TouchingWithinANanometreIsContact) {
  const ConvexBody box = ConvexBody::box({1, 1, 1});
  const Isometry3d origin = Isometry3d::Identity();
  const auto apart = [&](double gap) {
    return separation(box, origin, box, Isometry3d(Eigen::Translation3d(1 + gap, 0.3, 0.2)),
                      Vector3d::UnitY())
        .apart();
  };
  EXPECT_FALSE(apart(0.0));
  EXPECT_FALSE(apart(5e-10));
  EXPECT_FALSE(apart(-1e-12));
  EXPECT_TRUE(apart(5e-9));
}

TEST_F(SeparationTest, TheBallHoldsTheWholeBody) {
  for (int i = 0; i < kPoses; ++i) {
    const ConvexBody body = anyBody();
    const Vector3d direction = vector(1).normalized();
    EXPECT_LE((body.support(direction) + body.margin() * direction - body.centre()).norm(),
              body.radius() + 1e-12);
  }
}

}  // namespace
}  // namespace b4p::verification
