// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>

#include "planners/context_pool.h"
#include "planners/grasp_motion_checker.h"
#include "planners/manipulation_state_space.h"

namespace b4p {

/// Counts what has been asked of a checker, from any thread.
struct ValidityCounts {
  std::atomic<std::uint64_t> states{0};
  std::atomic<std::uint64_t> edges{0};
};

using GraspMotionPool = ContextPool<GraspMotionContext>;

/// A state is valid when it lies inside the joint limits and is free while holding its own grasp. Non-finite
/// states are invalid. Any thread may ask.
class ManipulationValidityChecker : public ompl::base::StateValidityChecker {
 public:
  ManipulationValidityChecker(const ompl::base::SpaceInformationPtr& si,
                              std::shared_ptr<GraspMotionPool> pool, std::shared_ptr<ValidityCounts> counts);
  bool isValid(const ompl::base::State* state) const override;

 private:
  std::shared_ptr<GraspMotionPool> pool_;
  std::shared_ptr<ValidityCounts> counts_;
};

/// A motion is valid when both states carry the same grasp and the straight edge is free while holding it,
/// **first state included**. Any thread may ask. lastValid is the last state found free; its fraction is 0
/// when the first state is not.
class ManipulationMotionValidator : public ompl::base::MotionValidator {
 public:
  ManipulationMotionValidator(const ompl::base::SpaceInformationPtr& si,
                              std::shared_ptr<GraspMotionPool> pool, std::shared_ptr<ValidityCounts> counts);
  bool checkMotion(const ompl::base::State* s1, const ompl::base::State* s2) const override;
  bool checkMotion(const ompl::base::State* s1, const ompl::base::State* s2,
                   std::pair<ompl::base::State*, double>& lastValid) const override;

 private:
  bool comparable(const ompl::base::State* s1, const ompl::base::State* s2) const;

  std::shared_ptr<GraspMotionPool> pool_;
  std::shared_ptr<ValidityCounts> counts_;
};

/// A SpaceInformation, set up, in which any OMPL planner plans motions of a held object.
/// @param counts  when given, counts the checks asked for
ompl::base::SpaceInformationPtr makeManipulationSpaceInformation(
    const std::shared_ptr<ManipulationStateSpace>& space, std::shared_ptr<const GraspMotionChecker> checker,
    std::shared_ptr<ValidityCounts> counts = std::make_shared<ValidityCounts>());

}  // namespace b4p
