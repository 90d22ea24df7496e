// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "experiments/certification/grasp_record.h"
#include "robots/shape.h"

namespace b4p {

/// Grasps that hold the object at about the same place from about the same side.
struct GraspBin {
  int position = 0;      ///< tenth of the object's longest side (0 ... 9) in which the TCP lies
  std::string approach;  ///< axis of the object that is nearest to the approach direction: "+x" ... "-z"
  int sampled = 0;
  int valid_at_pick = 0;
  int with_placement = 0;
  int compatible = 0;

  bool operator==(const GraspBin& other) const;
};

/// Sorts grasps into bins by position along the longest side of the object's bounding box (in O) and by
/// approach direction. Bins without grasps are left out; the others are in order of position and approach.
std::vector<GraspBin> binsOf(const std::vector<GraspRecord>& grasps, const std::vector<PlacedShape>& object);

}  // namespace b4p
