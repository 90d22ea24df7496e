// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/motion.h"

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>

#include "planners/manipulation_state_space.h"

namespace b4p {

namespace ob = ompl::base;

using ManipulationState = ManipulationStateSpace::StateType;

namespace {

/// How many values the states of a space consist of; 0 unless any of them can be set by itself.
unsigned independentValues(const ob::StateSpace& space) {
  if (const auto* joints = dynamic_cast<const ManipulationStateSpace*>(&space)) return joints->dof();
  if (const auto* vectors = dynamic_cast<const ob::RealVectorStateSpace*>(&space))
    return vectors->getDimension();
  if (dynamic_cast<const ob::SO2StateSpace*>(&space) != nullptr) return 1;
  if (!space.isCompound()) return 0;
  unsigned sum = 0;
  const auto& parts = *space.as<ob::CompoundStateSpace>();
  for (unsigned i = 0; i < parts.getSubspaceCount(); ++i) {
    const unsigned values = independentValues(*parts.getSubspace(i));
    if (values == 0) return 0;
    sum += values;
  }
  return sum;
}

}  // namespace

GraspAccess::GraspAccess(const ob::SpaceInformationPtr& si)
    : si_(si), present_(dynamic_cast<const ManipulationStateSpace*>(si->getStateSpace().get()) != nullptr) {}

GraspId GraspAccess::get(const ob::State* state) const {
  return present_ ? state->as<ManipulationState>()->grasp : kNoGrasp;
}

void GraspAccess::set(ob::State* state, GraspId grasp) const {
  if (present_) state->as<ManipulationState>()->grasp = grasp;
}

StateDistance GraspAccess::distance() const {
  const ob::StateSpace* space = si_->getStateSpace().get();
  if (present_) return StateDistance::ofJoints(*space->as<ManipulationStateSpace>());
  return [space](const ob::State* a, const ob::State* b) { return space->distance(a, b); };
}

bool GraspAccess::samePlace(const ob::State* a, const ob::State* b) const {
  if (!present_) return si_->equalStates(a, b);
  return si_->getStateSpace()->as<ManipulationStateSpace>()->jointDistance(a, b) == 0.0;
}

Motion::Motion(const ob::SpaceInformationPtr& si, double range)
    : si_(si),
      grasps_(si),
      distance_(grasps_.distance()),
      range_(range),
      symmetric_(si->getStateSpace()->hasSymmetricInterpolate()),
      values_(symmetric_ ? independentValues(*si->getStateSpace()) : 0),
      sampler_(si->allocStateSampler()) {
  sample_ = si_->allocState();
  from_ = si_->allocState();
  to_ = si_->allocState();
  end_ = si_->allocState();
  beside_ = si_->allocState();
}

Motion::~Motion() {
  for (ob::State* state : {sample_, from_, to_, end_, beside_}) si_->freeState(state);
}

const ob::State* Motion::sample() {
  sampler_->sampleUniform(sample_);
  return sample_;
}

const ob::State* Motion::sampleAround(const ob::State* a, const ob::State* b) {
  if (random_.uniformBool()) return sample();
  si_->getStateSpace()->interpolate(a, b, random_.uniform01(), to_);
  sampler_->sampleUniformNear(sample_, to_, distance_(a, b));
  return sample_;
}

Motion::Reach Motion::extend(const ob::State* from, const ob::State* to, GraspId grasp, Side side) {
  si_->copyState(from_, from);
  si_->copyState(to_, to);
  grasps_.set(from_, grasp);
  grasps_.set(to_, grasp);
  bool whole = true;
  const double distance = distance_(from_, to_);
  if (range_ > 0.0 && distance > range_) {
    si_->getStateSpace()->interpolate(from_, to_, range_ / distance, end_);
    si_->copyState(to_, end_);
    whole = false;
  }
  const bool backwards = side == Side::kPlace && !symmetric_;
  std::pair<ob::State*, double> last_valid{end_, 0.0};
  const bool free = backwards ? si_->isValid(to_) && si_->checkMotion(to_, from_)
                              : si_->checkMotion(from_, to_, last_valid);
  if (free) {
    si_->copyState(end_, to_);
    return whole ? Reach::kReached : Reach::kAdvanced;
  }
  if (backwards || last_valid.second <= 0.0) return Reach::kTrapped;
  // Validators that space their checks by an edge's length check other points of the shorter edge.
  const bool still_free = grasps_.present() || si_->checkMotion(from_, end_);
  return still_free ? Reach::kStopped : Reach::kTrapped;
}

const ob::State* Motion::alongValue(unsigned value, const ob::State* from, const ob::State* to) {
  const ob::StateSpace& space = *si_->getStateSpace();
  si_->copyState(beside_, from);
  double& moved = *space.getValueAddressAtIndex(beside_, value);
  const double there = *space.getValueAddressAtIndex(to, value);
  if (moved == there) return nullptr;
  moved = there;
  return beside_;
}

bool Motion::isFree(const ob::State* a, const ob::State* b, GraspId grasp) {
  si_->copyState(from_, a);
  si_->copyState(to_, b);
  grasps_.set(from_, grasp);
  grasps_.set(to_, grasp);
  return si_->checkMotion(from_, to_);
}

}  // namespace b4p
