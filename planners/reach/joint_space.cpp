// SPDX-License-Identifier: BSD-3-Clause
#include "planners/reach/joint_space.h"

#include <stdexcept>

#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "planners/manipulation_state_space.h"

namespace b4p {

namespace ob = ompl::base;

namespace {

using RealState = ob::RealVectorStateSpace::StateType;
using ManipulationState = ManipulationStateSpace::StateType;

const ob::RealVectorBounds& boundsOf(const ob::StateSpacePtr& space) {
  if (const auto* manipulation = dynamic_cast<const ManipulationStateSpace*>(space.get()))
    return manipulation->bounds();
  if (const auto* reals = dynamic_cast<const ob::RealVectorStateSpace*>(space.get()))
    return reals->getBounds();
  throw std::invalid_argument("reaching needs a state space of joint values with limits");
}

Eigen::VectorXd toVector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

JointSpace::JointSpace(const ob::StateSpacePtr& space)
    : carries_grasps_(dynamic_cast<const ManipulationStateSpace*>(space.get()) != nullptr) {
  const ob::RealVectorBounds& bounds = boundsOf(space);
  lower_ = toVector(bounds.low);
  upper_ = toVector(bounds.high);
  if (!lower_.allFinite() || !upper_.allFinite() || (lower_.array() > upper_.array()).any())
    throw std::invalid_argument("reaching needs finite joint limits, lower before upper");
}

double* JointSpace::q(ob::State* state) const {
  return carries_grasps_ ? state->as<ManipulationState>()->q : state->as<RealState>()->values;
}

const double* JointSpace::q(const ob::State* state) const {
  return carries_grasps_ ? state->as<ManipulationState>()->q : state->as<RealState>()->values;
}

bool JointSpace::contains(const double* q) const {
  const Eigen::Map<const Eigen::ArrayXd> values(q, lower_.size());
  return (values >= lower_.array()).all() && (values <= upper_.array()).all();  // false for NaN
}

StateDistance JointSpace::scaledDistance() const {
  const Eigen::ArrayXd range = upper_ - lower_;
  const Eigen::ArrayXd scale = (range > 0.0).select(range.inverse(), 0.0);
  return [joints = *this, scale](const ob::State* a, const ob::State* b) {
    const Eigen::Map<const Eigen::ArrayXd> qa(joints.q(a), scale.size()), qb(joints.q(b), scale.size());
    return ((qa - qb) * scale).matrix().norm();
  };
}

}  // namespace b4p
