// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/collision_pieces.h"

#include <stdexcept>

#include "state_validity/grown_shape.h"
#include "state_validity/link_groups.h"

namespace b4p {

CollisionPieces::CollisionPieces(const CollisionProblem& problem, double padding_m) {
  addLinks(*problem.robot, true, padding_m);
  object_begin_ = count();
  for (const PlacedShape& placed : problem.object) add(kHeldObject, -1, placed, padding_m);
  still_begin_ = count();
  addLinks(*problem.robot, false, 0.0);
  obstacle_begin_ = count();
  for (const Obstacle& obstacle : problem.obstacles) add(obstacle.name, -1, obstacle.shape, 0.0);
}

void CollisionPieces::add(const std::string& owner, int link, const PlacedShape& placed, double padding_m) {
  std::string problem = shapeProblem(placed.shape);
  if (problem.empty() && !placed.X_BS.matrix().allFinite()) problem = "the pose is not finite";
  if (!problem.empty()) throw std::invalid_argument(owner + ": " + problem);
  Piece piece{owner, link, placed.X_BS, grownShape(placed.shape, padding_m), {}, {}, fclShape(placed.shape)};
  piece.bounds = boundsOf(piece.grown);
  piece.fcl_grown = padding_m > 0.0 ? fclShape(piece.grown) : piece.fcl_bare;
  pieces_.push_back(std::move(piece));
}

void CollisionPieces::addLinks(const Manipulator& robot, bool moving, double padding_m) {
  // From the hand backwards: what is farthest from the base collides first.
  const std::vector<Link>& links = robot.model().links;
  for (int link = static_cast<int>(links.size()) - 1; link >= 0; --link) {
    if (isMoving(robot, link) != moving) continue;
    const Link& body = links[static_cast<std::size_t>(link)];
    for (const PlacedShape& placed : body.shapes) add(body.name, link, placed, padding_m);
  }
}

}  // namespace b4p
