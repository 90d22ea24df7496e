// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/grown_mesh.h"

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace b4p {
namespace {

// Cosine of the angle between two faces above which the edge between them is not worth a cut of its own.
constexpr double kBluntEdgeCosine = 0.85;
// Relative size below which a vector counts as having no direction.
constexpr double kNegligible = 1e-9;
// Cosine above which two directions count as one.
constexpr double kSameDirectionCosine = 1.0 - 1e-9;
// How far a corner may be off through rounding.
constexpr double kTolerance_m = 1e-9;

double support(const ConvexMesh& mesh, const Eigen::Vector3d& u) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& vertex : mesh.vertices) highest = std::max(highest, vertex.dot(u));
  return highest;
}

// Normals of the faces and, in between, of the sharp edges. Any set of directions gives a correct result
// (each plane is put where the mesh's own support says); this set makes it a tight one.
std::vector<Eigen::Vector3d> outwardDirections(const ConvexMesh& mesh) {
  std::vector<Eigen::Vector3d> directions;
  std::map<std::pair<int, int>, Eigen::Vector3d> normal_at_edge;
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.vertices[triangle[0]];
    const Eigen::Vector3d ab = mesh.vertices[triangle[1]] - a;
    const Eigen::Vector3d ac = mesh.vertices[triangle[2]] - a;
    const Eigen::Vector3d area = ab.cross(ac);
    if (area.norm() <= kNegligible * std::max(ab.squaredNorm(), ac.squaredNorm())) continue;
    const Eigen::Vector3d normal = area.normalized();
    directions.push_back(normal);
    for (int i = 0; i < 3; ++i) {
      const int from = triangle[i], to = triangle[(i + 1) % 3];
      const auto twin = normal_at_edge.find({to, from});
      if (twin == normal_at_edge.end()) {
        normal_at_edge[{from, to}] = normal;
      } else if (const Eigen::Vector3d between = normal + twin->second;
                 normal.dot(twin->second) < kBluntEdgeCosine && between.norm() > kNegligible) {
        directions.push_back(between.normalized());
      }
    }
  }
  return directions;
}

// Leaves out directions that repeat one already kept, as the triangles of one flat face do.
std::vector<Eigen::Vector3d> distinct(const std::vector<Eigen::Vector3d>& directions) {
  std::vector<Eigen::Vector3d> kept;
  for (const Eigen::Vector3d& u : directions)
    if (std::none_of(kept.begin(), kept.end(),
                     [&u](const auto& v) { return u.dot(v) > kSameDirectionCosine; }))
      kept.push_back(u);
  return kept;
}

// A half-space u . x <= offset, u a unit vector.
struct HalfSpace {
  Eigen::Vector3d u;
  double offset;
};

// Corners of the polyhedron bounded by half-spaces around the point `inside`. The plane u . (x - inside) = h
// corresponds to the point u / h, and a corner to a face of those points' convex hull.
std::vector<Eigen::Vector3d> cornersOf(const std::vector<HalfSpace>& half_spaces,
                                       const Eigen::Vector3d& inside) {
  std::vector<Eigen::Vector3d> poles;
  for (const HalfSpace& space : half_spaces) poles.push_back(space.u / (space.offset - space.u.dot(inside)));
  const std::shared_ptr<const ConvexMesh> dual = convexHull(poles);

  std::vector<Eigen::Vector3d> corners;
  for (const std::array<int, 3>& face : dual->triangles) {
    const Eigen::Vector3d& a = dual->vertices[face[0]];
    const Eigen::Vector3d ab = dual->vertices[face[1]] - a;
    const Eigen::Vector3d ac = dual->vertices[face[2]] - a;
    const Eigen::Vector3d normal = ab.cross(ac);
    // A face without area comes from a flat one cut into triangles; its neighbours say the same more
    // precisely.
    if (normal.norm() <= kNegligible * std::max(ab.squaredNorm(), ac.squaredNorm())) continue;
    corners.push_back(inside + normal / normal.dot(a));
  }
  return corners;
}

// True when every point within padding_m of the inner mesh's vertices lies inside the outer mesh.
bool containsGrown(const ConvexMesh& outer, const ConvexMesh& inner, double padding_m) {
  for (const std::array<int, 3>& face : outer.triangles) {
    const Eigen::Vector3d& a = outer.vertices[face[0]];
    const Eigen::Vector3d area = (outer.vertices[face[1]] - a).cross(outer.vertices[face[2]] - a);
    if (area.norm() == 0.0) continue;
    const Eigen::Vector3d u = area.normalized();
    if (support(inner, u) + padding_m > support(outer, u) + kTolerance_m) return false;
  }
  return true;
}

// The simple way, wider by up to sqrt(3) paddings: a cube around each vertex.
std::shared_ptr<const ConvexMesh> hullOfCubes(const ConvexMesh& mesh, double padding_m) {
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3d& vertex : mesh.vertices)
    for (const double x : {-padding_m, padding_m})
      for (const double y : {-padding_m, padding_m})
        for (const double z : {-padding_m, padding_m}) points.push_back(vertex + Eigen::Vector3d(x, y, z));
  return convexHull(points);
}

}  // namespace

std::shared_ptr<const ConvexMesh> grownMesh(const ConvexMesh& mesh, double padding_m) {
  Eigen::Vector3d inside = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& vertex : mesh.vertices)
    inside += vertex / static_cast<double>(mesh.vertices.size());
  std::vector<HalfSpace> half_spaces;
  for (const Eigen::Vector3d& u : distinct(outwardDirections(mesh)))
    half_spaces.push_back({u, support(mesh, u) + padding_m});

  try {
    const std::shared_ptr<const ConvexMesh> grown = convexHull(cornersOf(half_spaces, inside));
    if (containsGrown(*grown, mesh, padding_m)) return grown;
  } catch (const std::invalid_argument&) {
    // Too thin a mesh for the dual's arithmetic.
  }
  return hullOfCubes(mesh, padding_m);
}

}  // namespace b4p
