// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/posed_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstring>
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

// How many grasps are remembered at most; each takes the place of an earlier one that shares its slot.
constexpr std::size_t kSlots = 1024;

bool same(const Grasp& a, const Grasp& b) {
  return a.opening_m == b.opening_m && a.X_OT.matrix() == b.X_OT.matrix();
}

std::size_t slotOf(const Grasp& grasp) {
  std::uint64_t hash = 0;
  const auto mix = [&hash](double value) {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15ULL;
    hash ^= hash >> 32;
  };
  mix(grasp.opening_m);
  for (int i = 0; i < 3; ++i) {
    mix(grasp.X_OT.translation()[i]);
    mix(grasp.X_OT.linear()(0, i));
    mix(grasp.X_OT.linear()(1, i));
  }
  return static_cast<std::size_t>(hash % kSlots);
}

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
  known_.resize(kSlots);
  empty_.travel = world_->linkTravel();
  held_ = &empty_;
  empty_.rigid_collision = findRigidCollision();
}

void PosedPieces::hold(const Grasp* grasp) {
  if (!grasp) {
    held_ = &empty_;
    return;
  }
  if (holds() && same(*grasp, held_->grasp)) return;
  const std::size_t slot = slotOf(*grasp);
  HeldObject* known = known_[slot].get();
  held_ = known && same(*grasp, known->grasp) ? known : &remember(*grasp, slot);
}

HeldObject& PosedPieces::remember(const Grasp& grasp, std::size_t slot) {
  requireUsable(grasp, world_->robot().description().max_opening_m);
  held_ = &empty_;  // what the slot held may be the one in use
  known_[slot] = std::make_unique<HeldObject>();
  HeldObject& held = *known_[slot];
  held.held = true;
  held.grasp = grasp;
  held.X_TO = grasp.X_OT.inverse();
  held.serial = ++last_serial_;
  held_ = &held;
  held.rigid_collision = findRigidCollision();
  return held;
}

void PosedPieces::boundTravel() {
  const Manipulator& robot = world_->robot();
  const CollisionPieces& pieces = world_->pieces();
  held_->travel = Eigen::MatrixXd::Zero(robot.dof(), pieces.stillBegin());
  held_->travel.leftCols(pieces.objectBegin()) = world_->linkTravel();
  for (int i = pieces.objectBegin(); i < pieces.stillBegin(); ++i)
    held_->travel.col(i) =
        travelPerUnit(robot, robot.tcpLink(), {pieces[i].grown, held_->X_TO * pieces[i].X_BS});
}

const PiecePair* PosedPieces::findRigidCollision() {
  const std::vector<PiecePair>& rigid = world_->pairs(holds()).rigid;
  if (rigid.empty()) return nullptr;
  place(world_->robot().lower().data());  // any configuration will do
  for (const PiecePair& pair : rigid)
    if (overlap(pair, &Piece::fcl_bare)) return &pair;
  return nullptr;
}

void PosedPieces::place(const double* q) {
  const Manipulator& robot = world_->robot();
  const CollisionPieces& pieces = world_->pieces();
  robot.linkPoses(q, opening_m(), X_WL_);
  for (int i = 0; i < pieces.objectBegin(); ++i)
    X_WS_[index(i)] = X_WL_[index(pieces[i].link)] * pieces[i].X_BS;
  if (holds()) {
    const Eigen::Isometry3d X_WO = X_WL_[index(robot.tcpLink())] * held_->X_TO;
    for (int i = pieces.objectBegin(); i < pieces.stillBegin(); ++i) X_WS_[index(i)] = X_WO * pieces[i].X_BS;
  }
  for (int i = 0; i < movingCount(); ++i) bound(i);
}

double PosedPieces::sweptBound(const double* q1, const double* q2) {
  const Eigen::Index dof = travel().rows();
  const double* travel_m = travel().data();
  double farthest = 0.0;
  for (int i = 0; i < movingCount(); ++i, travel_m += dof) {
    double motion = 0.0;
    for (Eigen::Index j = 0; j < dof; ++j) motion += travel_m[j] * std::abs(q2[j] - q1[j]);
    farthest = std::max(farthest, motion);
  }
  return farthest;
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
