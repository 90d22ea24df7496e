// SPDX-License-Identifier: BSD-3-Clause
#include "planners/reach/grasp_ik.h"

#include <algorithm>
#include <numeric>

namespace b4p {

GraspDeck::GraspDeck(std::size_t grasps) : order_(grasps) { std::iota(order_.begin(), order_.end(), 0); }

GraspId GraspDeck::next(std::mt19937_64& random) {
  if (next_ == order_.size()) {
    next_ = 0;
    ++rounds_ended_;
  }
  if (next_ == 0) std::shuffle(order_.begin(), order_.end(), random);
  return order_[next_++];
}

GraspIk::GraspIk(const ReachRobot& robot, const ReachTargets& targets, const JointSpace& joints,
                 std::uint64_t seed)
    : context_(robot.makeContext()), targets_(targets), joints_(joints), random_(seed) {}

bool GraspIk::attempt(GraspId grasp, double* q) {
  const bool may_flip = targets_.tolerance().flip && !targets_.positionOnly();
  const bool flipped = may_flip && std::bernoulli_distribution()(random_);
  return context_->inverse(targets_.target(grasp, flipped), random_, q) && joints_.contains(q) &&
         targets_.within(grasp, context_->tcpPose(q));
}

}  // namespace b4p
