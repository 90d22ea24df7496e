// SPDX-License-Identifier: BSD-3-Clause
#include "robots/mesh_check.h"

#include <algorithm>
#include <set>
#include <utility>

#include "robots/number_text.h"

namespace b4p {
namespace {

constexpr double kConvexTolerance_m = 1e-6;
/// Triangles thinner than this have no dependable normal; their neighbours in the same face speak for them.
constexpr double kThinTriangle_m = 1e-8;
constexpr std::size_t kFewestVertices = 4;

const Eigen::Vector3d& corner(const ConvexMesh& mesh, const std::array<int, 3>& triangle, std::size_t i) {
  return mesh.vertices[static_cast<std::size_t>(triangle[i])];
}

bool indicesInRange(const ConvexMesh& mesh) {
  const int count = static_cast<int>(mesh.vertices.size());
  return std::all_of(
      mesh.triangles.begin(), mesh.triangles.end(), [count](const std::array<int, 3>& triangle) {
        return std::all_of(triangle.begin(), triangle.end(), [count](int i) { return i >= 0 && i < count; });
      });
}

/// Closed and consistently oriented: every directed edge occurs once, and so does its reverse.
bool isClosed(const ConvexMesh& mesh) {
  std::set<std::pair<int, int>> edges;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (!edges.emplace(t[i], t[(i + 1) % 3]).second) return false;
  return std::all_of(edges.begin(), edges.end(), [&edges](const auto& edge) {
    return edges.count({edge.second, edge.first}) == 1;
  });
}

double volume(const ConvexMesh& mesh) {
  double sixfold = 0.0;
  const Eigen::Vector3d& origin = mesh.vertices.front();
  for (const auto& t : mesh.triangles)
    sixfold +=
        (corner(mesh, t, 0) - origin).dot((corner(mesh, t, 1) - origin).cross(corner(mesh, t, 2) - origin));
  return sixfold / 6.0;
}

/// How far the farthest vertex lies outside the plane of a triangle (m).
double outside(const ConvexMesh& mesh, const std::array<int, 3>& triangle) {
  const Eigen::Vector3d& a = corner(mesh, triangle, 0);
  const Eigen::Vector3d ab = corner(mesh, triangle, 1) - a, ac = corner(mesh, triangle, 2) - a;
  const Eigen::Vector3d normal = ab.cross(ac);
  const double longest = std::max({ab.norm(), ac.norm(), (ac - ab).norm()});
  if (normal.norm() <= kThinTriangle_m * longest) return 0.0;
  const Eigen::Vector3d unit = normal.normalized();
  double farthest = 0.0;
  for (const Eigen::Vector3d& vertex : mesh.vertices) farthest = std::max(farthest, unit.dot(vertex - a));
  return farthest;
}

}  // namespace

std::string meshProblem(const ConvexMesh& mesh) {
  if (mesh.vertices.size() < kFewestVertices || mesh.triangles.size() < kFewestVertices)
    return "mesh has only " + std::to_string(mesh.vertices.size()) + " vertices and " +
           std::to_string(mesh.triangles.size()) + " triangles";
  for (const Eigen::Vector3d& vertex : mesh.vertices)
    if (!vertex.allFinite()) return "mesh has a vertex that is not finite";
  if (!indicesInRange(mesh)) return "mesh has a triangle with a corner that does not exist";
  if (!isClosed(mesh)) return "mesh is not closed";
  if (!(volume(mesh) > 0.0)) return "mesh encloses no volume or is turned inside out";
  for (const auto& triangle : mesh.triangles)
    if (const double depth = outside(mesh, triangle); depth > kConvexTolerance_m)
      return "mesh is not convex: a vertex lies " + numberText(depth) + " m outside one of its faces";
  return {};
}

}  // namespace b4p
