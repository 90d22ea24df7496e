// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include "planners/pick_place_region.h"

namespace b4p {

/// Square cells of one height on which an object may rest (paper, Section IV-A). World axes, z up.
struct ContactRegion {
  double height_m = 0.0;               ///< z of the contact points
  double cell_m = 0.0;                 ///< side length of a cell
  std::vector<Eigen::Vector2d> cells;  ///< centres; not empty
};

/// One pose of the object and the arm that holds it. The arm is the mode of a ManipulationStateSpace: state
/// (q, arm).
struct Placement {
  GraspId arm = kNoGrasp;
  int face = -1;                                   ///< number of the face that is put down
  int region = -1;                                 ///< number of the region its reference vertex lies on
  Eigen::Vector2d p_WV = Eigen::Vector2d::Zero();  ///< reference vertex in the world (m)
  double angle_rad = 0.0;                          ///< about the vertical through it, in [0, 2 pi)
};

/// One thread's access to a PlacementWorld. q arrays hold dof() values, finite and inside the joint limits;
/// poses are finite. Arms are numbers below armCount().
class PlacementContext {
 public:
  using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic>;

  virtual ~PlacementContext() = default;

  /// Whether the object alone touches no obstacle at pose X_WO.
  virtual bool objectFree(const Eigen::Isometry3d& X_WO) = 0;

  /// Whether the object and the hand that holds it touch no obstacle.
  virtual bool handFree(GraspId arm, const Eigen::Isometry3d& X_WO) = 0;

  /// One answer of inverse kinematics, with all its chance taken from `random`. True: `q` holds the object at
  /// X_WO and lies inside the joint limits; it may collide. False: none found; asking again may give one.
  virtual bool inverse(GraspId arm, const Eigen::Isometry3d& X_WO, std::mt19937_64& random, double* q) = 0;

  /// Whether the arm and the held object are free at q.
  virtual bool armFree(GraspId arm, const double* q) = 0;

  /// Pose X_WT of the arm's TCP.
  virtual Eigen::Isometry3d tcpPose(GraspId arm, const double* q) = 0;

  /// Pose X_WO of the object held by the arm.
  virtual Eigen::Isometry3d objectPose(GraspId arm, const double* q) = 0;

  /// Jacobian of a point fixed to the TCP in world axes, 6 x dof, reference point at the TCP's origin: rows
  /// 0-2 linear (m per rad or m), 3-5 angular (rad per rad or m).
  virtual Jacobian jacobian(GraspId arm, const double* q) = 0;
};

/// What placing needs to know of robot, object and surroundings. Immutable, shared by all threads; what
/// computes on scratch memory is in the contexts, one per thread.
class PlacementWorld {
 public:
  virtual ~PlacementWorld() = default;

  virtual unsigned dof() const = 0;      ///< joints of each arm
  virtual GraspId armCount() const = 0;  ///< arms that hold the object at will, each with one grasp
  virtual int faceCount() const = 0;     ///< placement faces of the object
  virtual const std::vector<ContactRegion>& regions() const = 0;

  /// Pose X_WO that a placement means; its arm does not matter.
  virtual Eigen::Isometry3d objectPose(const Placement& placement) const = 0;

  /// The placement whose pose is X_WO but for tolerance, with arm kNoGrasp. False when no face lies
  /// horizontally on a region.
  virtual bool locate(const Eigen::Isometry3d& X_WO, Placement& placement) const = 0;

  /// Whether a face is horizontal (within 0.01 rad) and each of its vertices touches a region of its own
  /// height, not necessarily the same one (Section IV-A).
  virtual bool stable(const Eigen::Isometry3d& X_WO) const = 0;

  virtual std::unique_ptr<PlacementContext> makeContext() const = 0;
};

}  // namespace b4p
