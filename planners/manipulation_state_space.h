// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include <ompl/base/StateSpace.h>
#include <ompl/base/spaces/RealVectorBounds.h>

#include "planners/pick_place_region.h"

namespace b4p {

/// States (q, grasp): a joint configuration and the grasp the object is held with (kNoGrasp: none).
///
/// distance() is the Euclidean joint distance, plus graspDistance() where the grasps differ. The default is
/// larger than any joint distance, so that trees of ordinary planners keep to one grasp. Between states of
/// different grasps there is no motion: interpolation stays at `from` for t < 1 (led nearer and nearer to
/// what it cannot reach, OMPL's RRTConnect would follow without end). A state with a non-finite value or
/// a grasp beyond those known satisfies no bounds. Serialisation and printing carry the grasp; copyToReals
/// carries q alone.
class ManipulationStateSpace : public ompl::base::StateSpace {
 public:
  class StateType : public ompl::base::State {
   public:
    double* q;  ///< dof values, in the same block of memory as the state
    GraspId grasp;
  };

  /// @param bounds  joint limits (rad or m). @throws ompl::Exception when empty, non-finite or reversed.
  explicit ManipulationStateSpace(const ompl::base::RealVectorBounds& bounds);

  unsigned int dof() const { return static_cast<unsigned int>(bounds_.low.size()); }
  const ompl::base::RealVectorBounds& bounds() const { return bounds_; }

  /// How far apart two grasps lie. >= 0.
  void setGraspDistance(double distance);
  double graspDistance() const { return grasp_distance_; }

  /// How many grasps are known: samplers draw ids below it (kNoGrasp while it is 0). Asked at every sample.
  void setGraspCount(std::function<GraspId()> count) { grasp_count_ = std::move(count); }
  GraspId graspCount() const { return grasp_count_ ? grasp_count_() : 0; }

  /// The largest joint distance inside the bounds.
  double jointExtent() const;
  double jointDistance(const ompl::base::State* a, const ompl::base::State* b) const;

  unsigned int getDimension() const override { return dof(); }
  double getMaximumExtent() const override;
  double getMeasure() const override;
  void enforceBounds(ompl::base::State* state) const override;
  bool satisfiesBounds(const ompl::base::State* state) const override;
  void copyState(ompl::base::State* destination, const ompl::base::State* source) const override;
  unsigned int getSerializationLength() const override;
  void serialize(void* serialization, const ompl::base::State* state) const override;
  void deserialize(ompl::base::State* state, const void* serialization) const override;
  double distance(const ompl::base::State* a, const ompl::base::State* b) const override;
  bool equalStates(const ompl::base::State* a, const ompl::base::State* b) const override;
  void interpolate(const ompl::base::State* from, const ompl::base::State* to, double t,
                   ompl::base::State* state) const override;
  ompl::base::StateSamplerPtr allocDefaultStateSampler() const override;
  ompl::base::State* allocState() const override;
  void freeState(ompl::base::State* state) const override;
  double* getValueAddressAtIndex(ompl::base::State* state, unsigned int index) const override;
  void printState(const ompl::base::State* state, std::ostream& out) const override;
  void printSettings(std::ostream& out) const override;
  void registerProjections() override;

 private:
  ompl::base::RealVectorBounds bounds_;
  double grasp_distance_;
  std::function<GraspId()> grasp_count_;
};

}  // namespace b4p
