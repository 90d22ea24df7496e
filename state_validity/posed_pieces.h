// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include <fcl/narrowphase/collision_request.h>
#include <fcl/narrowphase/collision_result.h>

#include "state_validity/fcl_world.h"

namespace b4p {

/// The pieces of a world at one configuration, with everything mutable that checking them needs. One object
/// per thread.
class PosedPieces {
 public:
  explicit PosedPieces(std::shared_ptr<const FclWorld> world);

  /// Says what is carried from now on; nullptr: nothing, fingers fully open. Cheap while the grasp stays the
  /// same.
  /// @throws std::invalid_argument for a grasp that is not finite or opens farther than the gripper can.
  void hold(const Grasp* grasp);

  /// Moves the robot to q, and what it carries with it.
  void place(const double* q);

  const FclWorld& world() const { return *world_; }
  /// Pairs that depend on q.
  const std::vector<PiecePair>& pairs() const { return world_->pairs(held_).moving; }

  /// A pair that collides at all configurations with what is held, nullptr if there is none.
  const PiecePair* rigidCollision() const { return rigid_collision_; }

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

  /// Bounds (m) of how far points of each moving piece travel per unit of each planned joint: column i
  /// is travelPerUnit of piece i, the carried object's included.
  const Eigen::MatrixXd& travel() const { return travel_; }

  /// Number of pieces that move now.
  int movingCount() const { return held_ ? world_->pieces().stillBegin() : world_->pieces().objectBegin(); }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  void bound(int i);
  const PiecePair* findRigidCollision();
  bool overlap(const PiecePair& pair, FclShape Piece::*shape);

  std::shared_ptr<const FclWorld> world_;
  bool ready_ = false;  ///< rigid_collision_ belongs to held_ and grasp_
  bool held_ = false;
  bool grasp_known_ = false;  ///< travel_ and X_TO_ belong to grasp_
  Grasp grasp_;
  const PiecePair* rigid_collision_ = nullptr;
  Eigen::Isometry3d X_TO_ = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Isometry3d> X_WL_;
  std::vector<Eigen::Isometry3d> X_WS_;
  std::vector<RoundedBox> boxes_;  ///< around the grown pieces
  std::vector<Aabb> aabbs_;        ///< around the boxes
  Eigen::MatrixXd travel_;
  fcl::CollisionRequestd request_;
  fcl::CollisionResultd result_;
};

}  // namespace b4p
