// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "state_validity/collision_pieces.h"

namespace b4p {

/// Two pieces that must not overlap.
struct PiecePair {
  int a = 0;  ///< moves
  int b = 0;
  std::vector<int> joints;  ///< planned joints (indices into q) that carry exactly one of the two
};

struct CollisionPairs {
  /// Pairs that planned joints move one relative to the other; most likely collisions first.
  std::vector<PiecePair> moving;
  /// The others: what is held and the link that carries it, or fingers on a base that stands still. A grasp
  /// decides about them once for all configurations. Without motion they need no padding and are checked
  /// bare.
  std::vector<PiecePair> rigid;
};

/// Pairs to check when nothing is carried, or also those of the carried object.
CollisionPairs collisionPairs(const Manipulator& robot, const CollisionPieces& pieces, bool with_object);

}  // namespace b4p
