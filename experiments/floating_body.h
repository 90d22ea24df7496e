// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "robots/manipulator.h"
#include "state_validity/collision_checker.h"

namespace b4p {

/// What moves rigidly with a robot's TCP, as a free body: the same collision checks without the arm, at a
/// hundredth of the cost of an inverse-kinematics attempt. One object per thread.
class FloatingBody {
 public:
  enum class Parts {
    kGripper,  ///< the last moving link with all that hangs on it, and the held object
    kObject,   ///< the held object alone
  };

  /// The checker behind such bodies, shared by all threads.
  static std::shared_ptr<const CollisionChecker> makeChecker(const CollisionProblem& problem, Parts parts);

  /// The same, of the kind of another checker.
  static std::shared_ptr<const CollisionChecker> makeChecker(const CollisionProblem& problem, Parts parts,
                                                             const CollisionChecker& like);

  explicit FloatingBody(const CollisionChecker& checker)
      : context_(checker.makeContext()), robot_(checker.problem().robot) {}

  /// Whether body and object are free with the TCP at X_WT.
  bool isFree(const Eigen::Isometry3d& X_WT, const Grasp& grasp);

  /// isFree() at each of many poses, at once.
  void areFree(const std::vector<Eigen::Isometry3d>& X_WT, const Grasp& grasp, std::vector<bool>& free);

  /// isFree() at X_WT moved by each of `shifts_m` (in W), at once.
  void areFreeShifted(const Eigen::Isometry3d& X_WT, const std::vector<Eigen::Vector3d>& shifts_m,
                      const Grasp& grasp, std::vector<bool>& free);

  /// Names of the first colliding pair, or "".
  std::string describeCollision(const Eigen::Isometry3d& X_WT, const Grasp& grasp);

 private:
  static CollisionProblem floating(const CollisionProblem& problem, Parts parts);
  std::array<double, 6> placedAt(const Eigen::Isometry3d& X_WT) const;
  void askAll(const Grasp& grasp, std::vector<bool>& free);

  std::unique_ptr<CollisionContext> context_;
  std::shared_ptr<const Manipulator> robot_;
  std::vector<double> q_;
};

}  // namespace b4p
