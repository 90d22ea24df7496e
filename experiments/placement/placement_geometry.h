// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "experiments/placement/clearance_objective.h"
#include "experiments/placement/contact_surfaces.h"
#include "experiments/placement/distance_field.h"
#include "experiments/placement/placement_faces.h"
#include "experiments/scene.h"

namespace b4p {

/// What pre-processing makes of a placement scene (paper, Section IV-A). Immutable; any thread may use it.
class PlacementGeometry {
 public:
  /// @param scene  with a placement task
  /// @throws InputError naming the scene's file and key: an object without a face to stand on, one larger
  /// than
  ///   the volume, a volume without a surface
  explicit PlacementGeometry(const Scene& scene);

  const OccupancyGrid& grid() const { return grid_; }
  const ContactSurfaces& surfaces() const { return *surfaces_; }
  const std::vector<PlacementFace>& faces() const { return faces_; }
  const std::shared_ptr<const DistanceField>& field() const { return field_; }

  /// Centres of the object's cells, in O.
  const std::vector<Eigen::Vector3d>& points_O() const { return points_O_; }

  std::shared_ptr<ClearanceObjective> objective(ClearanceGoal goal) const {
    return std::make_shared<ClearanceObjective>(field_, points_O_, goal);
  }

 private:
  OccupancyGrid grid_;
  std::unique_ptr<const ContactSurfaces> surfaces_;
  std::vector<PlacementFace> faces_;
  std::shared_ptr<const DistanceField> field_;
  std::vector<Eigen::Vector3d> points_O_;
};

}  // namespace b4p
