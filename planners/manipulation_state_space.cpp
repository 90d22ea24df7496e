// SPDX-License-Identifier: BSD-3-Clause
#include "planners/manipulation_state_space.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>

#include <ompl/base/ProjectionEvaluator.h>
#include <ompl/base/StateSampler.h>
#include <ompl/util/Exception.h>

namespace b4p {

namespace ob = ompl::base;

namespace {

using StateType = ManipulationStateSpace::StateType;

/// Joints uniform inside the limits, grasps uniform over those known.
class ManipulationStateSampler : public ob::StateSampler {
 public:
  explicit ManipulationStateSampler(const ManipulationStateSpace* space)
      : ob::StateSampler(space), manipulation_(*space) {}

  void sampleUniform(ob::State* state) override {
    auto* s = state->as<StateType>();
    const auto& bounds = manipulation_.bounds();
    for (unsigned i = 0; i < manipulation_.dof(); ++i)
      s->q[i] = rng_.uniformReal(bounds.low[i], bounds.high[i]);
    const GraspId count = manipulation_.graspCount();
    s->grasp = count > 0 ? rng_.uniformInt(0, count - 1) : kNoGrasp;
  }

  void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
    sampleAround(state, near,
                 [&](unsigned, double q) { return rng_.uniformReal(q - distance, q + distance); });
  }

  void sampleGaussian(ob::State* state, const ob::State* mean, double deviation) override {
    sampleAround(state, mean, [&](unsigned, double q) { return rng_.gaussian(q, deviation); });
  }

 private:
  template <class Draw>
  void sampleAround(ob::State* state, const ob::State* centre, Draw draw) {
    auto* s = state->as<StateType>();
    const auto* c = centre->as<StateType>();
    for (unsigned i = 0; i < manipulation_.dof(); ++i) s->q[i] = draw(i, c->q[i]);
    s->grasp = c->grasp;
    manipulation_.enforceBounds(s);
  }

  const ManipulationStateSpace& manipulation_;
};

/// The first three joints: what KPIECE, EST and others grid over.
class LeadingJointsProjection : public ob::ProjectionEvaluator {
 public:
  explicit LeadingJointsProjection(const ManipulationStateSpace* space)
      : ob::ProjectionEvaluator(space), manipulation_(*space) {}

  unsigned int getDimension() const override { return std::min(3u, manipulation_.dof()); }

  void defaultCellSizes() override {
    constexpr double kCellsPerJoint = 20.0;
    cellSizes_.resize(getDimension());
    bounds_.resize(getDimension());
    for (unsigned i = 0; i < getDimension(); ++i) {
      bounds_.low[i] = manipulation_.bounds().low[i];
      bounds_.high[i] = manipulation_.bounds().high[i];
      cellSizes_[i] = (bounds_.high[i] - bounds_.low[i]) / kCellsPerJoint;
    }
  }

  void project(const ob::State* state, Eigen::Ref<Eigen::VectorXd> projection) const override {
    for (unsigned i = 0; i < getDimension(); ++i) projection[i] = state->as<StateType>()->q[i];
  }

 private:
  const ManipulationStateSpace& manipulation_;
};

double extentOf(const ob::RealVectorBounds& bounds) {
  double squares = 0.0;
  for (std::size_t i = 0; i < bounds.low.size(); ++i) {
    const double width = bounds.high[i] - bounds.low[i];
    squares += width * width;
  }
  return std::sqrt(squares);
}

}  // namespace

ManipulationStateSpace::ManipulationStateSpace(const ob::RealVectorBounds& bounds) : bounds_(bounds) {
  if (bounds_.low.empty()) throw ompl::Exception("manipulation space: no joints");
  bounds_.check();
  const double extent = jointExtent();
  if (!std::isfinite(extent)) throw ompl::Exception("manipulation space: joint limits must be finite");
  constexpr double kBeyondAnyJointDistance = 1.1;
  grasp_distance_ = kBeyondAnyJointDistance * extent;
  setName("Manipulation" + getName());
  type_ = ob::STATE_SPACE_TYPE_COUNT + 1;
}

void ManipulationStateSpace::setGraspDistance(double distance) {
  if (!(distance >= 0.0) || !std::isfinite(distance))
    throw ompl::Exception("manipulation space: the grasp distance must be finite and >= 0");
  grasp_distance_ = distance;
}

double ManipulationStateSpace::jointDistance(const ob::State* a, const ob::State* b) const {
  const double* qa = a->as<StateType>()->q;
  const double* qb = b->as<StateType>()->q;
  double squares = 0.0;
  for (unsigned i = 0; i < dof(); ++i) squares += (qa[i] - qb[i]) * (qa[i] - qb[i]);
  return std::sqrt(squares);
}

double ManipulationStateSpace::jointExtent() const { return extentOf(bounds_); }

double ManipulationStateSpace::getMaximumExtent() const { return jointExtent() + grasp_distance_; }

double ManipulationStateSpace::getMeasure() const { return bounds_.getVolume(); }

void ManipulationStateSpace::enforceBounds(ob::State* state) const {
  double* q = state->as<StateType>()->q;
  for (unsigned i = 0; i < dof(); ++i) q[i] = std::clamp(q[i], bounds_.low[i], bounds_.high[i]);
}

bool ManipulationStateSpace::satisfiesBounds(const ob::State* state) const {
  const double* q = state->as<StateType>()->q;
  for (unsigned i = 0; i < dof(); ++i)
    if (!(q[i] >= bounds_.low[i] && q[i] <= bounds_.high[i])) return false;  // also when q[i] is NaN
  const GraspId grasp = state->as<StateType>()->grasp;
  return grasp == kNoGrasp || (grasp >= 0 && (!grasp_count_ || grasp < grasp_count_()));
}

void ManipulationStateSpace::copyState(ob::State* destination, const ob::State* source) const {
  auto* d = destination->as<StateType>();
  const auto* s = source->as<StateType>();
  std::copy(s->q, s->q + dof(), d->q);
  d->grasp = s->grasp;
}

unsigned int ManipulationStateSpace::getSerializationLength() const {
  return static_cast<unsigned int>(dof() * sizeof(double) + sizeof(GraspId));
}

void ManipulationStateSpace::serialize(void* serialization, const ob::State* state) const {
  const auto* s = state->as<StateType>();
  auto* bytes = static_cast<char*>(serialization);
  std::memcpy(bytes, s->q, dof() * sizeof(double));
  std::memcpy(bytes + dof() * sizeof(double), &s->grasp, sizeof(GraspId));
}

void ManipulationStateSpace::deserialize(ob::State* state, const void* serialization) const {
  auto* s = state->as<StateType>();
  const auto* bytes = static_cast<const char*>(serialization);
  std::memcpy(s->q, bytes, dof() * sizeof(double));
  std::memcpy(&s->grasp, bytes + dof() * sizeof(double), sizeof(GraspId));
}

double ManipulationStateSpace::distance(const ob::State* a, const ob::State* b) const {
  const bool same_grasp = a->as<StateType>()->grasp == b->as<StateType>()->grasp;
  return jointDistance(a, b) + (same_grasp ? 0.0 : grasp_distance_);
}

bool ManipulationStateSpace::equalStates(const ob::State* a, const ob::State* b) const {
  const auto* sa = a->as<StateType>();
  const auto* sb = b->as<StateType>();
  return sa->grasp == sb->grasp && std::equal(sa->q, sa->q + dof(), sb->q);
}

void ManipulationStateSpace::interpolate(const ob::State* from, const ob::State* to, double t,
                                         ob::State* state) const {
  const auto* a = from->as<StateType>();
  const auto* b = to->as<StateType>();
  auto* s = state->as<StateType>();
  const GraspId grasp = t < 1.0 ? a->grasp : b->grasp;
  const bool there_is_a_motion = a->grasp == b->grasp;
  if (t >= 1.0) {
    std::copy(b->q, b->q + dof(), s->q);  // the end exactly, not a + (b - a)
  } else {
    const double way = there_is_a_motion ? t : 0.0;
    for (unsigned i = 0; i < dof(); ++i) s->q[i] = a->q[i] + way * (b->q[i] - a->q[i]);
  }
  s->grasp = grasp;
}

ob::StateSamplerPtr ManipulationStateSpace::allocDefaultStateSampler() const {
  return std::make_shared<ManipulationStateSampler>(this);
}

// A state and its joint values share one block, so that a copy touches one cache line or two.
ob::State* ManipulationStateSpace::allocState() const {
  static_assert(sizeof(StateType) % alignof(double) == 0, "joint values follow the state");
  void* block = ::operator new(sizeof(StateType) + dof() * sizeof(double));
  auto* state = new (block) StateType;
  state->q = new (static_cast<char*>(block) + sizeof(StateType)) double[dof()];
  state->grasp = kNoGrasp;
  return state;
}

void ManipulationStateSpace::freeState(ob::State* state) const {
  auto* s = static_cast<StateType*>(state);
  s->~StateType();
  ::operator delete(s);
}

double* ManipulationStateSpace::getValueAddressAtIndex(ob::State* state, unsigned int index) const {
  return index < dof() ? state->as<StateType>()->q + index : nullptr;
}

void ManipulationStateSpace::printState(const ob::State* state, std::ostream& out) const {
  if (state == nullptr) {
    out << "ManipulationState [nullptr]\n";
    return;
  }
  const auto* s = state->as<StateType>();
  out << "ManipulationState [grasp " << s->grasp << ":";
  for (unsigned i = 0; i < dof(); ++i) out << ' ' << s->q[i];
  out << "]\n";
}

void ManipulationStateSpace::printSettings(std::ostream& out) const {
  out << "Manipulation state space '" << getName() << "' of " << dof() << " joints, grasps "
      << grasp_distance_ << " apart\n";
}

void ManipulationStateSpace::registerProjections() {
  registerDefaultProjection(std::make_shared<LeadingJointsProjection>(this));
}

}  // namespace b4p
