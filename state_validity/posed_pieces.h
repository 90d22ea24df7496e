// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <fcl/narrowphase/collision_request.h>
#include <fcl/narrowphase/collision_result.h>

#include "state_validity/fcl_world.h"

namespace b4p {

/// What belongs to one grasp, or to empty hands.
struct HeldObject {
  bool held = false;
  Grasp grasp;  ///< where held
  Eigen::Isometry3d X_TO = Eigen::Isometry3d::Identity();
  /// Bounds (m) of how far points of each moving piece travel per unit of each planned joint: column i
  /// is travelPerUnit of piece i, the carried object's included where held. Empty until PosedPieces::travel()
  /// is asked, since single states do not need it.
  Eigen::MatrixXd travel;
  const PiecePair* rigid_collision = nullptr;  ///< a pair that collides at all configurations
  std::uint64_t serial = 0;                    ///< unlike those of all others of the same PosedPieces
};

/// The pieces of a world at one configuration, with everything mutable that checking them needs. One object
/// per thread.
class PosedPieces {
 public:
  explicit PosedPieces(std::shared_ptr<const FclWorld> world);

  /// Says what is carried from now on; nullptr: nothing, fingers fully open. Cheap for the grasps of late.
  /// @throws std::invalid_argument for a grasp that is not finite or opens farther than the gripper can.
  void hold(const Grasp* grasp);

  /// Moves the robot to q, and what it carries with it.
  void place(const double* q);

  const FclWorld& world() const { return *world_; }
  /// Pairs that depend on q.
  const std::vector<PiecePair>& pairs() const { return world_->pairs(holds()).moving; }

  /// What is carried now.
  const HeldObject& held() const { return *held_; }
  bool holds() const { return held_->held; }

  /// A pair that collides at all configurations with what is held, nullptr if there is none.
  const PiecePair* rigidCollision() const { return held_->rigid_collision; }

  /// Gripper opening (m) with what is held.
  double opening_m() const {
    return holds() ? held_->grasp.opening_m : world_->robot().description().max_opening_m;
  }

  /// Lower bound (m) of the distance of two grown pieces as placed; 0 if they may overlap. It is exact enough
  /// to tell whether it exceeds kClearlyApart_m or `enough_m`, not beyond.
  double gap(const PiecePair& pair, double enough_m) const;

  /// Whether two grown pieces overlap as placed. FCL decides unless they are clearly apart.
  bool collide(const PiecePair& pair) {
    return gap(pair, kClearlyApart_m) <= kClearlyApart_m && overlap(pair);
  }

  /// FCL's verdict on two grown pieces as placed.
  bool overlap(const PiecePair& pair) { return overlap(pair, &Piece::fcl_grown); }

  /// FCL's iterations may call pieces overlapping that are apart by less than its tolerance of 1e-6 m. Only
  /// pairs farther apart than this are passed over, so that every answer is what FCL would say.
  static constexpr double kClearlyApart_m = 1e-5;

  /// HeldObject::travel of what is held.
  const Eigen::MatrixXd& travel() {
    if (held_->travel.size() == 0) boundTravel();
    return held_->travel;
  }

  /// Bound (m) of how far any point of a moving piece travels from q1 to q2.
  double sweptBound(const double* q1, const double* q2);

  /// Number of pieces that move now.
  int movingCount() const { return holds() ? world_->pieces().stillBegin() : world_->pieces().objectBegin(); }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  void bound(int i);
  void boundTravel();
  HeldObject& remember(const Grasp& grasp, std::size_t slot);
  const PiecePair* findRigidCollision();
  bool overlap(const PiecePair& pair, FclShape Piece::*shape);

  std::shared_ptr<const FclWorld> world_;
  HeldObject empty_;
  std::vector<std::unique_ptr<HeldObject>> known_;  ///< by slotOf()
  HeldObject* held_ = nullptr;
  std::uint64_t last_serial_ = 0;
  std::vector<Eigen::Isometry3d> X_WL_;
  std::vector<Eigen::Isometry3d> X_WS_;
  std::vector<RoundedBox> boxes_;  ///< around the grown pieces
  std::vector<Aabb> aabbs_;        ///< around the boxes
  fcl::CollisionRequestd request_;
  fcl::CollisionResultd result_;
};

}  // namespace b4p
