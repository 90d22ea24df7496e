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
  const std::vector<PiecePair>& pairs() const { return world_->pairs(held_); }

  /// Lower bound (m) of the distance of two grown pieces as placed; 0 if they may overlap.
  double gap(const PiecePair& pair) const { return aabbs_[index(pair.a)].gapTo(aabbs_[index(pair.b)]); }

  bool mayOverlap(const PiecePair& pair) const {
    return aabbs_[index(pair.a)].overlaps(aabbs_[index(pair.b)]);
  }

  /// FCL's verdict on two pieces as placed.
  bool overlap(const PiecePair& pair);

  /// Bounds (m) of how far points of each moving piece travel per unit of each planned joint: column i
  /// is travelPerUnit of piece i, the carried object's included.
  const Eigen::MatrixXd& travel() const { return travel_; }

  /// Number of pieces that move now.
  int movingCount() const { return held_ ? world_->pieces().stillBegin() : world_->pieces().objectBegin(); }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  std::shared_ptr<const FclWorld> world_;
  bool held_ = false;
  Grasp grasp_;
  bool grasp_known_ = false;  ///< travel_ and X_TO_ belong to grasp_
  Eigen::Isometry3d X_TO_ = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Isometry3d> X_WL_;
  std::vector<Eigen::Isometry3d> X_WS_;
  std::vector<Aabb> aabbs_;  ///< of the grown pieces
  Eigen::MatrixXd travel_;
  fcl::CollisionRequestd request_;
  fcl::CollisionResultd result_;
};

}  // namespace b4p
