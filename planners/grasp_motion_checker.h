// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "planners/pick_place_region.h"

namespace b4p {

/// One thread's access to a GraspMotionChecker. With kNoGrasp nothing is carried. May throw
/// std::invalid_argument on non-finite q or an unknown grasp.
class GraspMotionContext {
 public:
  virtual ~GraspMotionContext() = default;

  virtual bool isFree(const double* q, GraspId grasp) = 0;

  /// True when the straight edge is free, both ends included.
  virtual bool isEdgeFree(const double* q1, const double* q2, GraspId grasp) = 0;

  /// Largest fraction of q1 -> q2 free from q1 on: 1 for the whole edge, negative when q1 is not free.
  virtual double freeFraction(const double* q1, const double* q2, GraspId grasp) = 0;
};

/// What planning needs to know of robot and world: which configurations and straight motions are free while
/// the object is held with a given grasp. Shared by all threads; each thread takes its own context.
class GraspMotionChecker {
 public:
  virtual ~GraspMotionChecker() = default;
  virtual std::unique_ptr<GraspMotionContext> makeContext() const = 0;
};

}  // namespace b4p
