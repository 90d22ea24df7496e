// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "experiments/scene.h"
#include "experiments/verification/convex_body.h"
#include "experiments/verification/kinematics.h"
#include "robots/grasp.h"

namespace b4p::verification {

/// Two things that may not touch and do.
struct Contact {
  std::string first, second;
  double fraction;  ///< where on the edge, 0 to 1
};

/// Something that stands in the world and is no obstacle of the scene's.
struct StandingBody {
  std::string name;
  PlacedBody placed;  ///< in the world
};

/// Moves robot and held object along edges and looks for contact. Holds scratch: one thread.
///
/// Samples of an edge lie so close that no point moves more than step_m between them. A pair of bodies
/// measured d apart cannot come closer than the smallest distance c seen so far while its relative motion
/// stays within d - c; it is measured again at the first sample beyond. So every sample is checked, and no
/// distance at one is below the clearance.
class CollisionSweep {
 public:
  /// @param robot     has to outlive the sweep
  /// @param standing  stands in the way besides the scene's obstacles
  /// @throws InputError for names of links that the robot does not have.
  CollisionSweep(const Scene& scene, const Kinematics& robot, const Grasp& grasp, double step_m,
                 const std::vector<StandingBody>& standing = {});

  /// Steps that the edge from q1 to q2 is divided into, at least 1. Beyond kMostSteps (infinite where the
  /// step is next to nothing) the edge cannot be swept.
  double steps(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2) const;
  static constexpr double kMostSteps = 1e7;

  /// The first contact on the straight edge from q1 to q2, both included.
  /// @throws std::length_error when it has more than kMostSteps
  std::optional<Contact> firstContact(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2);

  double step_m() const { return step_m_; }
  long samples() const { return samples_; }  ///< configurations covered so far
  /// Smallest distance at any of them (m); 0 when nothing could touch.
  double clearance_m() const;

 private:
  static constexpr int kWorld = -1;

  struct Body {
    std::string name;
    int link;   ///< frame it is fixed in, or kWorld
    bool held;  ///< part of the held object
    PlacedBody placed;
    Eigen::VectorXd motion_per_unit;  ///< see Kinematics
    Eigen::Isometry3d X_WS;           ///< where it is at the sample looked at
    Eigen::Vector3d p_WC;             ///< centre of its ball
  };
  struct Pair {
    int a, b;
    double motion_m;            ///< relative motion over the edge, at most
    double due;                 ///< number of the sample at which to measure next
    Eigen::Vector3d direction;  ///< of the gap found last
  };

  void addObject(const std::string& name, const std::vector<PlacedShape>& pieces, const Grasp& grasp);
  void addBodies(const Scene& scene, const Grasp& grasp);
  void addPairs(const Scene& scene);
  void addBody(std::string name, int link, bool held, const PlacedBody& placed);
  void prepareEdge(const Eigen::VectorXd& change);
  void moveTo(const Eigen::VectorXd& q);
  bool measure(Pair& pair, double sample, double count);

  const Kinematics& robot_;
  double opening_m_;
  double step_m_;
  std::vector<Body> bodies_;
  std::vector<Pair> pairs_;
  double closest_m_ = std::numeric_limits<double>::infinity();
  long samples_ = 0;
};

}  // namespace b4p::verification
