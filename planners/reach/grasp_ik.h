// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "planners/reach/joint_space.h"
#include "planners/reach/reach_robot.h"
#include "planners/reach/reach_targets.h"

namespace b4p {

/// Draws grasps without replacement: every grasp once in random order, then all again in another.
class GraspDeck {
 public:
  explicit GraspDeck(std::size_t grasps);

  /// @param random  where the order comes from
  GraspId next(std::mt19937_64& random);

  /// How often all grasps have been drawn, the round under way left aside.
  std::uint64_t roundsEnded() const { return rounds_ended_; }

 private:
  std::vector<GraspId> order_;
  std::size_t next_ = 0;
  std::uint64_t rounds_ended_ = 0;
};

/// Inverse kinematics of grasps, for one thread. What it answers lies inside the joint limits and within the
/// grasp's tolerance: both are checked here, whatever the robot's own solver says.
class GraspIk {
 public:
  /// @param targets, joints  have to outlive this object
  GraspIk(const ReachRobot& robot, const ReachTargets& targets, const JointSpace& joints, std::uint64_t seed);

  /// One attempt at a grasp, or at its flip where that counts as the same.
  bool attempt(GraspId grasp, double* q);

  std::mt19937_64& random() { return random_; }

 private:
  std::unique_ptr<ReachContext> context_;
  const ReachTargets& targets_;
  const JointSpace& joints_;
  std::mt19937_64 random_;
};

}  // namespace b4p
