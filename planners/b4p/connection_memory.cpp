// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/connection_memory.h"

namespace b4p {

std::optional<const Tree*> ConnectionMemory::placeTree(PlacementId placement, GraspId grasp) const {
  std::lock_guard<std::mutex> lock(mutex_);
  const auto found = place_trees_.find({placement, grasp});
  return found == place_trees_.end() ? std::nullopt : std::optional<const Tree*>(found->second);
}

void ConnectionMemory::setPlaceTree(PlacementId placement, GraspId grasp, const Tree* tree) {
  std::lock_guard<std::mutex> lock(mutex_);
  const Tree*& known = place_trees_[{placement, grasp}];
  if (known == nullptr) known = tree;  // two workers may have asked at once, and one found the other's root
}

bool ConnectionMemory::mayJoin(const Tree* pick, const Tree* place) const {
  std::lock_guard<std::mutex> lock(mutex_);
  const auto found = size_to_retry_.find({pick, place});
  return found == size_to_retry_.end() || pick->size + place->size >= found->second;
}

void ConnectionMemory::repairFailed(const Tree* pick, const Tree* place) {
  std::lock_guard<std::mutex> lock(mutex_);
  size_to_retry_[{pick, place}] = 2 * (pick->size + place->size);
}

}  // namespace b4p
