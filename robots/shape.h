// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Geometry>

namespace b4p {

/// Solid shapes, all convex, in metres. Each has its own frame S with the origin at its centre;
/// the axis of cylinders and capsules is z of S.
struct Box {
  Eigen::Vector3d size;  ///< full side lengths along x, y, z; each > 0
};
struct Sphere {
  double radius;  ///< > 0
};
struct Cylinder {
  double radius;  ///< > 0
  double length;  ///< > 0, between the flat ends
};
struct Capsule {
  double radius;  ///< > 0
  double length;  ///< >= 0, between the centres of the two end spheres
};
/// Vertices of a convex polyhedron with outward, counter-clockwise triangles; the origin of S may lie
/// anywhere.
struct ConvexMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;
};

using Shape = std::variant<Box, Sphere, Cylinder, Capsule, std::shared_ptr<const ConvexMesh>>;

/// A shape S fixed in the frame of a body B.
struct PlacedShape {
  Shape shape;
  Eigen::Isometry3d X_BS = Eigen::Isometry3d::Identity();
};

/// Empty when the sizes are finite and in range (and a mesh closed and convex within 1e-6 m);
/// otherwise what is wrong, with the value.
std::string shapeProblem(const Shape& shape);

/// Largest distance (m) from the point p_B (in B) to any point of the shape. Exact for every shape.
double farthestDistance(const PlacedShape& placed, const Eigen::Vector3d& p_B);

/// Upper bound of the distance (m) of any point of the shape from the line through p_B along the
/// unit vector u_B (both in B); exact for boxes, spheres, capsules and meshes.
double farthestDistanceFromLine(const PlacedShape& placed, const Eigen::Vector3d& p_B,
                                const Eigen::Vector3d& u_B);

/// The convex hull (qhull) of a set of points.
/// @throws std::invalid_argument if the points are non-finite or span no volume.
std::shared_ptr<const ConvexMesh> convexHull(const std::vector<Eigen::Vector3d>& points);

}  // namespace b4p
