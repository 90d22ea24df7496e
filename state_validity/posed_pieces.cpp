// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/posed_pieces.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include <fcl/narrowphase/collision.h>

#include "state_validity/separation.h"
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
  boxes_.resize(index(pieces.count()));
  aabbs_.resize(index(pieces.count()));
  robot.linkPoses(robot.lower().data(), robot.description().max_opening_m, X_WL_);
  for (int i = pieces.stillBegin(); i < pieces.count(); ++i) {
    const int link = pieces[i].link;
    X_WS_[index(i)] = link < 0 ? pieces[i].X_BS : X_WL_[index(link)] * pieces[i].X_BS;
    bound(i);
  }
  travel_ = Eigen::MatrixXd::Zero(robot.dof(), pieces.stillBegin());
  travel_.leftCols(pieces.objectBegin()) = world_->linkTravel();
}

void PosedPieces::hold(const Grasp* grasp) {
  const bool same_grasp = grasp && grasp_known_ && grasp->opening_m == grasp_.opening_m &&
                          grasp->X_OT.matrix() == grasp_.X_OT.matrix();
  const bool held = grasp != nullptr;
  if (ready_ && held == held_ && (!held || same_grasp)) return;
  if (held && !same_grasp) {
    const Manipulator& robot = world_->robot();
    requireUsable(*grasp, robot.description().max_opening_m);
    grasp_ = *grasp;
    X_TO_ = grasp_.X_OT.inverse();
    const CollisionPieces& pieces = world_->pieces();
    for (int i = pieces.objectBegin(); i < pieces.stillBegin(); ++i)
      travel_.col(i) = travelPerUnit(robot, robot.tcpLink(), {pieces[i].grown, X_TO_ * pieces[i].X_BS});
    grasp_known_ = true;
  }
  held_ = held;
  rigid_collision_ = findRigidCollision();
  ready_ = true;
}

const PiecePair* PosedPieces::findRigidCollision() {
  const std::vector<PiecePair>& rigid = world_->pairs(held_).rigid;
  if (rigid.empty()) return nullptr;
  place(world_->robot().lower().data());  // any configuration will do
  for (const PiecePair& pair : rigid)
    if (overlap(pair, &Piece::fcl_bare)) return &pair;
  return nullptr;
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
  for (int i = 0; i < movingCount(); ++i) bound(i);
}

void PosedPieces::bound(int i) {
  boxes_[index(i)] = world_->pieces()[i].bounds.posed(X_WS_[index(i)]);
  aabbs_[index(i)] = boxes_[index(i)].aabb();
}

double PosedPieces::gap(const PiecePair& pair, double enough_m) const {
  const std::size_t a = index(pair.a), b = index(pair.b);
  const double aabb_gap_m = aabbs_[a].gapTo(aabbs_[b]);
  if (aabb_gap_m > enough_m) return aabb_gap_m;
  return separation(boxes_[a], boxes_[b], aabb_gap_m, kClearlyApart_m, enough_m);
}

bool PosedPieces::overlap(const PiecePair& pair, FclShape Piece::*shape) {
  const FclShape& shape_a = world_->pieces()[pair.a].*shape;
  const FclShape& shape_b = world_->pieces()[pair.b].*shape;
  result_.clear();
  fcl::collide(shape_a.get(), X_WS_[index(pair.a)], shape_b.get(), X_WS_[index(pair.b)], request_, result_);
  return result_.isCollision();
}

}  // namespace b4p
