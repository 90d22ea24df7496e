// SPDX-License-Identifier: BSD-3-Clause
#include "planners/reach/reach_goal.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <stdexcept>
#include <utility>

#include <ompl/base/SpaceInformation.h>
#include <ompl/util/Console.h>

namespace b4p {

namespace ob = ompl::base;

ReachGoal::ReachGoal(const ob::SpaceInformationPtr& si, std::shared_ptr<const ReachRobot> robot,
                     ReachTargets targets)
    : ob::GoalSampleableRegion(si),
      robot_(std::move(robot)),
      targets_(std::move(targets)),
      joints_(si->getStateSpace()),
      grasps_(si),
      contexts_([robot = robot_] { return robot->makeContext(); }) {
  if (robot_ == nullptr) throw std::invalid_argument("reaching needs a robot");
  if (robot_->dof() != joints_.dof())
    throw std::invalid_argument("the robot has " + std::to_string(robot_->dof()) +
                                " joints, the state space " + std::to_string(joints_.dof()));
  setThreshold(std::numeric_limits<double>::epsilon());
  seed(0);
}

void ReachGoal::seed(std::uint64_t seed) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ik_ = std::make_unique<GraspIk>(*robot_, targets_, joints_, seed);
  deck_ = std::make_unique<GraspDeck>(targets_.size());
  attempt_.assign(joints_.dof(), 0.0);
  answer_.clear();
}

void ReachGoal::setAttempts(unsigned attempts) {
  if (attempts == 0) throw std::invalid_argument("a goal sample needs at least one attempt");
  attempts_ = attempts;
}

bool ReachGoal::drawAnswer() const {
  const GraspId grasp = deck_->next(ik_->random());
  for (unsigned i = 0; i < attempts_; ++i)
    if (ik_->attempt(grasp, attempt_.data())) return true;
  return false;
}

void ReachGoal::sampleGoal(ob::State* state) const {
  grasps_.set(state, kNoGrasp);
  double* q = joints_.q(state);
  const std::lock_guard<std::mutex> lock(mutex_);
  try {
    if (drawAnswer()) answer_ = attempt_;
  } catch (const std::exception& e) {
    OMPL_WARN("inverse kinematics of a goal sample: %s", e.what());
  } catch (...) {
    OMPL_WARN("inverse kinematics of a goal sample: an exception of unknown type");
  }
  if (!answer_.empty()) {
    std::copy(answer_.begin(), answer_.end(), q);
    return;
  }
  constexpr double kOutside = 1e-6;
  for (unsigned i = 0; i < joints_.dof(); ++i)
    q[i] = joints_.upper()[i] + kOutside * std::max(1.0, joints_.upper()[i] - joints_.lower()[i]);
}

unsigned int ReachGoal::maxSampleCount() const { return std::numeric_limits<unsigned int>::max(); }

ReachGoal::Nearest ReachGoal::nearest(const ob::State* state) const {
  Nearest nearest{kNoGrasp, std::numeric_limits<double>::infinity()};
  const double* q = joints_.q(state);
  if (grasps_.get(state) != kNoGrasp || !joints_.contains(q)) return nearest;
  const Eigen::Isometry3d X_WT = contexts_.lease()->tcpPose(q);
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const auto grasp = static_cast<GraspId>(i);
    const double distance = targets_.distance(grasp, X_WT);
    if (distance < nearest.distance) nearest = {grasp, distance};
  }
  return nearest;
}

double ReachGoal::distanceGoal(const ob::State* state) const { return nearest(state).distance; }

GraspId ReachGoal::graspOf(const ob::State* state) const {
  const Nearest found = nearest(state);
  return found.distance == 0.0 ? found.grasp : kNoGrasp;
}

}  // namespace b4p
