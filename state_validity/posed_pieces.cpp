// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/posed_pieces.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include <fcl/narrowphase/collision.h>

#include "state_validity/swept_motion.h"

namespace b4p {
namespace {

// A grasp may exceed the gripper's opening by this much through rounding.
constexpr double kOpeningTolerance_m = 1e-9;

void requireUsable(const Grasp& grasp, double max_opening_m) {
  if (!grasp.X_OT.matrix().allFinite() || !std::isfinite(grasp.opening_m))
    throw std::invalid_argument("the grasp is not finite");
  if (grasp.opening_m < -kOpeningTolerance_m || grasp.opening_m > max_opening_m + kOpeningTolerance_m)
    throw std::invalid_argument("the grasp opens the gripper by " + std::to_string(grasp.opening_m) +
                                " m, which has to lie in [0, " + std::to_string(max_opening_m) + "]");
}

}  // namespace

PosedPieces::PosedPieces(std::shared_ptr<const FclWorld> world) : world_(std::move(world)) {
  const CollisionPieces& pieces = world_->pieces();
  const Manipulator& robot = world_->robot();
  X_WS_.resize(index(pieces.count()), Eigen::Isometry3d::Identity());
  aabbs_.resize(index(pieces.count()));
  robot.linkPoses(robot.lower().data(), robot.description().max_opening_m, X_WL_);
  for (int i = pieces.stillBegin(); i < pieces.count(); ++i) {
    const int link = pieces[i].link;
    X_WS_[index(i)] = link < 0 ? pieces[i].X_BS : X_WL_[index(link)] * pieces[i].X_BS;
    aabbs_[index(i)] = pieces[i].bounds.aabb(X_WS_[index(i)]);
  }
  travel_ = Eigen::MatrixXd::Zero(robot.dof(), pieces.stillBegin());
  travel_.leftCols(pieces.objectBegin()) = world_->linkTravel();
}

void PosedPieces::hold(const Grasp* grasp) {
  held_ = grasp != nullptr;
  if (!held_) return;
  if (grasp_known_ && grasp->opening_m == grasp_.opening_m && grasp->X_OT.matrix() == grasp_.X_OT.matrix())
    return;
  const Manipulator& robot = world_->robot();
  requireUsable(*grasp, robot.description().max_opening_m);
  grasp_known_ = true;
  grasp_ = *grasp;
  X_TO_ = grasp_.X_OT.inverse();
  const CollisionPieces& pieces = world_->pieces();
  for (int i = pieces.objectBegin(); i < pieces.stillBegin(); ++i)
    travel_.col(i) = travelPerUnit(robot, robot.tcpLink(), {pieces[i].grown, X_TO_ * pieces[i].X_BS});
}

void PosedPieces::place(const double* q) {
  const Manipulator& robot = world_->robot();
  const CollisionPieces& pieces = world_->pieces();
  robot.linkPoses(q, held_ ? grasp_.opening_m : robot.description().max_opening_m, X_WL_);
  for (int i = 0; i < pieces.objectBegin(); ++i)
    X_WS_[index(i)] = X_WL_[index(pieces[i].link)] * pieces[i].X_BS;
  if (held_) {
    const Eigen::Isometry3d X_WO = X_WL_[index(robot.tcpLink())] * X_TO_;
    for (int i = pieces.objectBegin(); i < pieces.stillBegin(); ++i) X_WS_[index(i)] = X_WO * pieces[i].X_BS;
  }
  for (int i = 0; i < movingCount(); ++i) aabbs_[index(i)] = pieces[i].bounds.aabb(X_WS_[index(i)]);
}

bool PosedPieces::overlap(const PiecePair& pair) {
  const Piece& a = world_->pieces()[pair.a];
  const Piece& b = world_->pieces()[pair.b];
  const FclShape& shape_a = pair.bare ? a.fcl_bare : a.fcl_grown;
  const FclShape& shape_b = pair.bare ? b.fcl_bare : b.fcl_grown;
  result_.clear();
  fcl::collide(shape_a.get(), X_WS_[index(pair.a)], shape_b.get(), X_WS_[index(pair.b)], request_, result_);
  return result_.isCollision();
}

}  // namespace b4p
