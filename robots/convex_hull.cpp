// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <stdexcept>
#include <utility>

#include <libqhullcpp/Qhull.h>
#include <libqhullcpp/QhullFacetList.h>
#include <libqhullcpp/QhullVertexSet.h>

#include "robots/shape.h"

namespace b4p {
namespace {

constexpr int kDimension = 3;
constexpr std::size_t kFewestPoints = 4;

/// Corners of a triangular facet as numbers of input points, counter-clockwise seen from outside.
std::array<int, 3> corners(orgQhull::QhullFacet facet) {
  std::array<int, 3> points{};
  std::size_t i = 0;
  for (const orgQhull::QhullVertex& vertex : facet.vertices()) {
    if (i == points.size()) throw std::invalid_argument("qhull left a facet that is not a triangle");
    points[i++] = static_cast<int>(vertex.point().id());
  }
  // Qhull's orientation flag holds for triangles of any area; a cross product fails on thin ones.
  if (facet.isTopOrient()) std::swap(points[0], points[1]);
  return points;
}

}  // namespace

std::shared_ptr<const ConvexMesh> convexHull(const std::vector<Eigen::Vector3d>& points) {
  for (const Eigen::Vector3d& point : points)
    if (!point.allFinite()) throw std::invalid_argument("a point is not finite");
  if (points.size() < kFewestPoints) throw std::invalid_argument("fewer than 4 points span no volume");

  auto hull = std::make_shared<ConvexMesh>();
  try {
    orgQhull::Qhull qhull;
    qhull.runQhull("", kDimension, static_cast<int>(points.size()), points.front().data(), "Qt Pp");
    std::map<int, int> vertex_of_point;
    for (const orgQhull::QhullFacet& facet : qhull.facetList()) {
      std::array<int, 3> triangle = corners(facet);
      for (int& corner : triangle) {
        const auto [entry, is_new] = vertex_of_point.emplace(corner, static_cast<int>(hull->vertices.size()));
        if (is_new) hull->vertices.push_back(points[static_cast<std::size_t>(corner)]);
        corner = entry->second;
      }
      hull->triangles.push_back(triangle);
    }
  } catch (const orgQhull::QhullError&) {
    throw std::invalid_argument("the points span no volume");
  }
  return hull;
}

}  // namespace b4p
