// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "state_validity/collision_pieces.h"

namespace b4p {

/// Two pieces that must not overlap.
struct PiecePair {
  int a = 0;  ///< moves
  int b = 0;
  /// True when nothing planned moves one relative to the other: the held object and the gripper's body. Such
  /// a pair needs no padding and is checked as it is.
  bool bare = false;
  std::vector<int> joints;  ///< planned joints (indices into q) that carry exactly one of the two
};

/// Pairs to check when nothing is carried, or also those of the carried object; most likely collisions first.
std::vector<PiecePair> collisionPairs(const Manipulator& robot, const CollisionPieces& pieces,
                                      bool with_object);

}  // namespace b4p
