// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/placement_geometry.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "experiments/placement/solid.h"
#include "robots/input_error.h"
#include "robots/number_text.h"

namespace b4p {
namespace {

std::vector<PlacementFace> facesOf(const Scene& scene) {
  std::vector<PlacementFace> faces;
  const std::vector<Eigen::Vector3d> points = hullPoints(scene.placing().object);
  try {
    if (!containsPoint(convexHull(points), scene.placing().p_OCom))
      throw InputError(scene.file, "place.centre_of_mass_m", "lies outside the object");
    faces = placementFaces(points, scene.placing().p_OCom);
  } catch (const std::invalid_argument& e) {
    throw InputError(scene.file, "object", e.what());
  }
  if (faces.empty())
    throw InputError(scene.file, "object",
                     "has no face that it can stand on, with its centre of mass at least 1 cm inside");
  return faces;
}

/// The largest distance of two of the face's corners.
double extent(const PlacementFace& face) {
  double largest = 0.0;
  for (const Eigen::Vector3d& a : face.vertices_O)
    for (const Eigen::Vector3d& b : face.vertices_O) largest = std::max(largest, (a - b).norm());
  return largest;
}

void requireFits(const Scene& scene, const std::vector<PlacementFace>& faces) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const PlacementFace& face : faces) smallest = std::min(smallest, extent(face));
  const double across = (scene.placing().max_m - scene.placing().min_m).head<2>().norm();
  if (smallest > across)
    throw InputError(scene.file, "object",
                     "is larger than the target volume: its smallest face is " + numberText(smallest) +
                         " m across, the volume " + numberText(across) + " m");
}

OccupancyGrid gridOf(const Scene& scene) {
  OccupancyGrid grid(latticeInside(scene.placing().min_m, scene.placing().max_m, scene.placing().cell_m));
  for (const Obstacle& obstacle : scene.obstacles) grid.add(obstacle.shape);
  return grid;
}

std::vector<Eigen::Vector3d> pointsOf(const Scene& scene) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : hullPoints(scene.placing().object)) box.extend(p);
  OccupancyGrid grid(latticeAround(box.min(), box.max(), scene.placing().cell_m));
  for (const PlacedShape& shape : scene.placing().object) grid.add(shape);
  return grid.occupiedCentres();
}

}  // namespace

PlacementGeometry::PlacementGeometry(const Scene& scene) : grid_(gridOf(scene)), faces_(facesOf(scene)) {
  requireFits(scene, faces_);
  surfaces_ = std::make_unique<const ContactSurfaces>(grid_);
  if (surfaces_->regions().empty())
    throw InputError(scene.file, "place.volume",
                     "holds no surface to stand on: nowhere are 3 x 3 cells occupied beneath a free one");
  field_ = std::make_shared<const DistanceField>(grid_);
  points_O_ = pointsOf(scene);
}

}  // namespace b4p
