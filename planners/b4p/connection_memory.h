// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "planners/b4p/forest.h"

namespace b4p {

/// What has been learnt about joining trees of different grasps: answers of Eq. 3, and pairs of trees whose
/// repair failed. Any thread may ask.
class ConnectionMemory {
 public:
  /// The place tree that Eq. 3 gave for this placement and grasp (nullptr inside: it has no solution), or
  /// nothing when it was not asked yet.
  std::optional<const Tree*> placeTree(PlacementId placement, GraspId grasp) const;
  void setPlaceTree(PlacementId placement, GraspId grasp, const Tree* tree);

  /// False after a failed repair between the two, until together they have doubled in size.
  bool mayJoin(const Tree* pick, const Tree* place) const;
  void repairFailed(const Tree* pick, const Tree* place);

 private:
  mutable std::mutex mutex_;
  std::map<std::pair<PlacementId, GraspId>, const Tree*> place_trees_;
  std::map<std::pair<const Tree*, const Tree*>, std::size_t> size_to_retry_;
};

}  // namespace b4p
