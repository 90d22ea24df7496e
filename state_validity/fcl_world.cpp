// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/fcl_world.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include <fcl/narrowphase/collision.h>

#include "state_validity/swept_motion.h"

namespace b4p {
namespace {

// Default padding: an unchecked configuration of an edge is at most this fraction of a step away from a
// checked one.
constexpr double kPaddingPerStep = 0.5;

CollisionProblem checkedProblem(CollisionProblem problem) {
  if (!problem.robot) throw std::invalid_argument("the collision problem has no robot");
  if (!std::isfinite(problem.edge_step_m) || problem.edge_step_m <= 0.0)
    throw std::invalid_argument("edge_step_m has to be positive and finite, not " +
                                std::to_string(problem.edge_step_m));
  if (problem.padding_m < 0.0) problem.padding_m = kPaddingPerStep * problem.edge_step_m;
  if (!std::isfinite(problem.padding_m))
    throw std::invalid_argument("padding_m has to be finite, not " + std::to_string(problem.padding_m));
  return problem;
}

// Links that never move are held against the obstacles once, here. This is also FCL's first call: it sets up
// a table that all threads read later.
void checkStillLinks(const Manipulator& robot, const CollisionPieces& pieces) {
  std::vector<Eigen::Isometry3d> X_WL;
  robot.linkPoses(robot.lower().data(), robot.description().max_opening_m, X_WL);
  const fcl::CollisionRequestd request;
  for (int a = pieces.stillBegin(); a < pieces.obstacleBegin(); ++a) {
    const Eigen::Isometry3d X_WA = X_WL[static_cast<std::size_t>(pieces[a].link)] * pieces[a].X_BS;
    for (int b = pieces.obstacleBegin(); b < pieces.count(); ++b) {
      fcl::CollisionResultd result;
      fcl::collide(pieces[a].fcl_bare.get(), X_WA, pieces[b].fcl_bare.get(), pieces[b].X_BS, request, result);
      if (result.isCollision())
        throw std::invalid_argument("link '" + pieces[a].owner + "', which does not move, collides with '" +
                                    pieces[b].owner + "'");
    }
  }
  const Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
  const FclShape probe = fclShape(Sphere{1.0});
  fcl::CollisionResultd result;
  fcl::collide(probe.get(), origin, probe.get(), origin, request, result);
}

}  // namespace

FclWorld::FclWorld(CollisionProblem problem)
    : problem_(checkedProblem(std::move(problem))),
      pieces_(problem_, problem_.padding_m),
      pairs_empty_(collisionPairs(robot(), pieces_, false)),
      pairs_held_(collisionPairs(robot(), pieces_, true)),
      link_travel_(robot().dof(), pieces_.objectBegin()) {
  checkStillLinks(robot(), pieces_);
  for (int i = 0; i < pieces_.objectBegin(); ++i)
    link_travel_.col(i) = travelPerUnit(robot(), pieces_[i].link, {pieces_[i].grown, pieces_[i].X_BS});
}

}  // namespace b4p
