// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include <ompl/base/goals/GoalSampleableRegion.h>

#include "planners/b4p/motion.h"
#include "planners/context_pool.h"
#include "planners/reach/grasp_ik.h"
#include "planners/reach/joint_space.h"
#include "planners/reach/reach_robot.h"
#include "planners/reach/reach_targets.h"

namespace b4p {

/// "The empty hand is at one of these grasps": a goal over joint values for any OMPL planner. JPlusRRT,
/// IKRRT and BIKRRT recognise it and choose grasps themselves.
///
/// A state of a ManipulationStateSpace that holds something is not in the goal. sampleGoal() takes the grasps
/// in random order, each once a round, with attempts() attempts of inverse kinematics; its answers may
/// collide, as goal samples may. Where no answer is found it repeats the last one there was. Without any, its
/// sample lies outside the limits by a millionth of a joint's range: planners reject it, and the few that
/// step towards goal samples unasked (OMPL's RRT, RRTstar) stay among finite values. Never throws. Any thread
/// may ask.
class ReachGoal : public ompl::base::GoalSampleableRegion {
 public:
  /// @throws std::invalid_argument when the space is not one of joint values with finite limits, or the robot
  ///   is missing or has another number of joints
  ReachGoal(const ompl::base::SpaceInformationPtr& si, std::shared_ptr<const ReachRobot> robot,
            ReachTargets targets);

  const ReachRobot& robot() const { return *robot_; }
  const ReachTargets& targets() const { return targets_; }
  const JointSpace& joints() const { return joints_; }

  /// Restarts the stream that sampleGoal() draws from.
  void seed(std::uint64_t seed);

  /// Attempts of inverse kinematics per sample. @throws std::invalid_argument for 0.
  void setAttempts(unsigned attempts);
  unsigned attempts() const { return attempts_; }

  /// The grasp that a state satisfies, the first where they are several; kNoGrasp for none.
  GraspId graspOf(const ompl::base::State* state) const;

  void sampleGoal(ompl::base::State* state) const override;
  unsigned int maxSampleCount() const override;

  /// ReachTargets::distance() to the nearest grasp: 0 exactly inside the goal; infinite outside the joint
  /// limits.
  double distanceGoal(const ompl::base::State* state) const override;

 private:
  struct Nearest {
    GraspId grasp = kNoGrasp;
    double distance;
  };
  Nearest nearest(const ompl::base::State* state) const;
  bool drawAnswer() const;

  std::shared_ptr<const ReachRobot> robot_;
  const ReachTargets targets_;
  const JointSpace joints_;
  const GraspAccess grasps_;
  unsigned attempts_ = 4;
  mutable ContextPool<ReachContext> contexts_;
  mutable std::mutex mutex_;  // guards what follows
  mutable std::unique_ptr<GraspIk> ik_;
  mutable std::unique_ptr<GraspDeck> deck_;
  mutable std::vector<double> attempt_, answer_;  ///< joint values; `answer_` is empty while there is none
};

}  // namespace b4p
