// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/placement_faces.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace b4p {
namespace {

struct Triangle {
  std::array<int, 3> corners;
  Eigen::Vector3d normal;
  double area_m2;
};

std::vector<Triangle> largestFirst(const ConvexMesh& hull) {
  constexpr double kNoArea_m2 = 1e-14;
  std::vector<Triangle> triangles;
  for (const auto& corners : hull.triangles) {
    const auto at = [&](int i) {
      return hull.vertices[static_cast<std::size_t>(corners.at(static_cast<std::size_t>(i)))];
    };
    const Eigen::Vector3d doubled = (at(1) - at(0)).cross(at(2) - at(0));
    if (doubled.norm() / 2.0 > kNoArea_m2)
      triangles.push_back({corners, doubled.normalized(), doubled.norm() / 2.0});
  }
  std::stable_sort(triangles.begin(), triangles.end(),
                   [](const Triangle& a, const Triangle& b) { return a.area_m2 > b.area_m2; });
  return triangles;
}

/// Axes of a plane: x and y span it, z is the normal.
Eigen::Matrix3d axesOf(const Eigen::Vector3d& normal) {
  Eigen::Matrix3d axes;
  axes.col(2) = normal;
  axes.col(0) = normal.unitOrthogonal();
  axes.col(1) = normal.cross(axes.col(0));
  return axes;
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Corners of the hull of points in a plane, counter-clockwise, as numbers of points (Andrew's monotone
/// chain).
std::vector<std::size_t> planarHull(const std::vector<Eigen::Vector2d>& points) {
  constexpr double kStraight_m2 = 1e-12;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(points[a].x(), points[a].y()) < std::pair(points[b].x(), points[b].y());
  });
  std::vector<std::size_t> hull;
  const auto addSide = [&](auto begin, auto end) {
    const std::size_t start = hull.size();
    for (auto i = begin; i != end; ++i) {
      while (hull.size() >= start + 2 && cross(points[hull.back()] - points[hull[hull.size() - 2]],
                                               points[*i] - points[hull.back()]) <= kStraight_m2)
        hull.pop_back();
      hull.push_back(*i);
    }
    hull.pop_back();
  };
  addSide(order.begin(), order.end());
  addSide(order.rbegin(), order.rend());
  return hull;
}

/// How far inside a counter-clockwise convex polygon a point lies; negative outside.
double depthInside(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& p) {
  double depth = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d side = polygon[(i + 1) % polygon.size()] - polygon[i];
    depth = std::min(depth, cross(side, p - polygon[i]) / side.norm());
  }
  return depth;
}

}  // namespace

std::vector<PlacementFace> placementFaces(const std::vector<Eigen::Vector3d>& points_O,
                                          const Eigen::Vector3d& p_OCom, const FaceRules& rules) {
  constexpr std::size_t kFewestCorners = 3;
  constexpr double kRounding_m = 1e-9;
  const auto hull = convexHull(points_O);
  const std::vector<Triangle> triangles = largestFirst(*hull);
  std::vector<char> taken(triangles.size(), 0);
  std::vector<PlacementFace> faces;
  for (std::size_t seed = 0; seed < triangles.size(); ++seed) {
    if (taken[seed]) continue;
    const Eigen::Vector3d normal = triangles[seed].normal;
    std::set<int> corners;
    for (std::size_t i = seed; i < triangles.size(); ++i) {
      if (taken[i] || triangles[i].normal.dot(normal) <= std::cos(rules.cluster_rad)) continue;
      taken[i] = 1;
      corners.insert(triangles[i].corners.begin(), triangles[i].corners.end());
    }
    double lowest = -std::numeric_limits<double>::infinity();
    for (const int corner : corners)
      lowest = std::max(lowest, normal.dot(hull->vertices[static_cast<std::size_t>(corner)]));
    const Eigen::Matrix3d axes = axesOf(normal);
    std::vector<Eigen::Vector3d> touching;
    std::vector<Eigen::Vector2d> outline;
    for (const int corner : corners) {
      const Eigen::Vector3d& p = hull->vertices[static_cast<std::size_t>(corner)];
      if (normal.dot(p) < lowest - rules.flat_m) continue;
      touching.push_back(p);
      outline.emplace_back((axes.transpose() * p).head<2>());
    }
    if (touching.size() < kFewestCorners) continue;
    PlacementFace face;
    face.normal_O = normal;
    std::vector<Eigen::Vector2d> polygon;
    for (const std::size_t i : planarHull(outline)) {
      face.vertices_O.push_back(touching[i]);
      polygon.push_back(outline[i]);
    }
    if (polygon.size() < kFewestCorners) continue;
    const Eigen::Vector2d com = (axes.transpose() * p_OCom).head<2>();
    if (depthInside(polygon, com) < rules.com_inside_m - kRounding_m) continue;
    // F has its z axis along -normal, so its x and y axes swap to stay right-handed.
    Eigen::Matrix3d R_OF;
    R_OF << axes.col(1), axes.col(0), -normal;
    Eigen::Isometry3d X_OF = Eigen::Isometry3d::Identity();
    X_OF.linear() = R_OF;
    X_OF.translation() = face.vertices_O.front();
    face.X_FO = X_OF.inverse();
    faces.push_back(std::move(face));
  }
  return faces;
}

}  // namespace b4p
