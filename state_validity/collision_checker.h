// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "robots/grasp.h"
#include "robots/manipulator.h"

namespace b4p {

/// Something fixed in the world W.
struct Obstacle {
  std::string name;
  PlacedShape shape;  ///< X_BS is its pose in W
};

/// What is checked against what, and how finely.
struct CollisionProblem {
  std::shared_ptr<const Manipulator> robot;
  std::vector<Obstacle> obstacles;
  std::vector<PlacedShape> object;  ///< the carried object's shapes in its frame O; may be empty
  /// Largest distance any point of robot or held object travels between two checks of an edge (m). > 0.
  double edge_step_m = 0.01;
  /// Robot and held object are grown by this much in all directions (m). With edge_step_m / 2, the
  /// default (any negative value), an edge found free is free everywhere, between the checks as well: no
  /// point is farther than half a step from one that was checked. 0 checks the bare shapes. Between two
  /// links, or link and held object, each carries its own padding, since each may move half a step. What does
  /// not move has none: obstacles, links fixed to the base, and the held object towards the link that carries
  /// it.
  double padding_m = -1.0;
};

/// What one thread uses to ask about validity; not to be shared. The robot is checked against the obstacles
/// and itself, the held object against the obstacles and the robot's links, fingers excepted.
///
/// q arrays hold dof() values. `held` is the grasp with which the object is carried; nullptr: nothing is
/// carried, fingers fully open. All functions throw std::invalid_argument on non-finite q or grasp, and on a
/// grasp that opens farther than the gripper can. Never checked against each other: links that no planned
/// joint moves one relative to the other, links joined by one joint (with what is fixed to them), pairs that
/// the robot's description skips, and the held object and the finger links.
class CollisionContext {
 public:
  virtual ~CollisionContext() = default;

  /// True when q lies inside the joint limits and nothing collides.
  virtual bool isFree(const double* q, const Grasp* held) = 0;

  /// isFree() of `count` configurations, dof() values each, at once.
  virtual void areFree(const double* q, int count, const Grasp* held, bool* free) = 0;

  /// True when every checked configuration of the straight edge q1 -> q2 is free, **q1 and q2 included**.
  virtual bool isEdgeFree(const double* q1, const double* q2, const Grasp* held) = 0;

  /// Largest fraction t such that q1 + s (q2 - q1) was found free at every check with s <= t, q1 included; 1
  /// when the whole edge is free, a negative value when q1 is not free. isEdgeFree(q1, q2) is
  /// freeFraction(q1, q2) == 1, and the edge from q1 to the configuration at t, computed as q1 + t (q2 - q1),
  /// is free by isEdgeFree again.
  virtual double freeFraction(const double* q1, const double* q2, const Grasp* held) = 0;

  /// Names of the first colliding pair at q ("panda_hand, shelf_top"; the object is called "held object"), or
  /// of the joint outside its limits, or "" when free. Slow; for messages.
  virtual std::string describeCollision(const double* q, const Grasp* held) = 0;

  /// How many configurations have been looked at in isFree(), areFree(), isEdgeFree() and freeFraction() so
  /// far; 0 where a checker does not count. Of an edge these are fewer than its checks: many are known to be
  /// free from others. The vectorised checker looks at up to 16 together, and counts all of them.
  virtual std::uint64_t configurationsChecked() const { return 0; }
};

/// Immutable after construction and shared by all threads; each thread takes its own context. Contexts
/// keep the checker's data alive.
class CollisionChecker {
 public:
  virtual ~CollisionChecker() = default;
  virtual std::unique_ptr<CollisionContext> makeContext() const = 0;
  virtual const CollisionProblem& problem() const = 0;

  /// A checker of the same kind for another problem.
  /// @throws std::invalid_argument as makeFclChecker does.
  virtual std::shared_ptr<const CollisionChecker> sameKindFor(CollisionProblem problem) const = 0;

  /// What answers, and with which restrictions, in one line; for messages and records.
  virtual std::string description() const = 0;
};

/// The exact reference, through FCL.
/// @throws std::invalid_argument for a missing robot, steps that are not positive and finite, bad shapes, and
/// a link that
///   never moves inside an obstacle, naming both.
std::shared_ptr<const CollisionChecker> makeFclChecker(CollisionProblem problem);

/// The same answers many times as fast: bounds of distances, worked out for many configurations at once in
/// the processor's widest registers, settle nearly all of them, and FCL what they leave open.
/// @throws std::invalid_argument as makeFclChecker does.
std::shared_ptr<const CollisionChecker> makeVectorChecker(CollisionProblem problem);

}  // namespace b4p
