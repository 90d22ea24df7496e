// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "state_validity/collision_checker.h"
#include "state_validity/fcl_shapes.h"
#include "state_validity/shape_bounds.h"

namespace b4p {

/// The owner of the carried object's shapes, in messages.
inline constexpr const char* kHeldObject = "held object";

/// One convex shape that takes part in collision checks.
struct Piece {
  std::string owner;       ///< name of link or obstacle, or kHeldObject
  int link = -1;           ///< model link it is fixed to; -1 for obstacles and the held object
  Eigen::Isometry3d X_BS;  ///< in the frame of the link, of the object, or of the world
  Shape grown;             ///< by the padding if it moves, bare otherwise
  ShapeBounds bounds;      ///< of `grown`
  FclShape fcl_grown;
  FclShape fcl_bare;
};

/// All pieces of a problem in one list, in this order: links that move, the held object, links that stand
/// still, obstacles. A link stands still if neither planned joints nor fingers move it. Immutable.
class CollisionPieces {
 public:
  /// @throws std::invalid_argument naming the owner of a bad shape or pose.
  CollisionPieces(const CollisionProblem& problem, double padding_m);

  const Piece& operator[](int i) const { return pieces_[static_cast<std::size_t>(i)]; }
  int count() const { return static_cast<int>(pieces_.size()); }
  int objectBegin() const { return object_begin_; }      ///< moving links come before
  int stillBegin() const { return still_begin_; }        ///< everything from here on stands still
  int obstacleBegin() const { return obstacle_begin_; }  ///< links that stand still come before

 private:
  void add(const std::string& owner, int link, const PlacedShape& placed, double padding_m);
  void addLinks(const Manipulator& robot, bool moving, double padding_m);

  std::vector<Piece> pieces_;
  int object_begin_ = 0;
  int still_begin_ = 0;
  int obstacle_begin_ = 0;
};

}  // namespace b4p
