// SPDX-License-Identifier: BSD-3-Clause
#include "planners/manipulation_validity.h"

#include <algorithm>
#include <utility>

namespace b4p {

namespace ob = ompl::base;

using StateType = ManipulationStateSpace::StateType;

ManipulationValidityChecker::ManipulationValidityChecker(const ob::SpaceInformationPtr& si,
                                                         std::shared_ptr<GraspMotionPool> pool,
                                                         std::shared_ptr<ValidityCounts> counts)
    : ob::StateValidityChecker(si), pool_(std::move(pool)), counts_(std::move(counts)) {}

bool ManipulationValidityChecker::isValid(const ob::State* state) const {
  counts_->states.fetch_add(1, std::memory_order_relaxed);
  if (!si_->satisfiesBounds(state)) return false;
  const auto* s = state->as<StateType>();
  return pool_->lease()->isFree(s->q, s->grasp);
}

ManipulationMotionValidator::ManipulationMotionValidator(const ob::SpaceInformationPtr& si,
                                                         std::shared_ptr<GraspMotionPool> pool,
                                                         std::shared_ptr<ValidityCounts> counts)
    : ob::MotionValidator(si), pool_(std::move(pool)), counts_(std::move(counts)) {}

bool ManipulationMotionValidator::comparable(const ob::State* s1, const ob::State* s2) const {
  counts_->edges.fetch_add(1, std::memory_order_relaxed);
  return s1->as<StateType>()->grasp == s2->as<StateType>()->grasp && si_->satisfiesBounds(s1) &&
         si_->satisfiesBounds(s2);
}

bool ManipulationMotionValidator::checkMotion(const ob::State* s1, const ob::State* s2) const {
  if (!comparable(s1, s2)) return false;
  const auto* a = s1->as<StateType>();
  return pool_->lease()->isEdgeFree(a->q, s2->as<StateType>()->q, a->grasp);
}

bool ManipulationMotionValidator::checkMotion(const ob::State* s1, const ob::State* s2,
                                              std::pair<ob::State*, double>& lastValid) const {
  double fraction = 0.0;
  if (comparable(s1, s2)) {
    const auto* a = s1->as<StateType>();
    fraction = std::max(0.0, pool_->lease()->freeFraction(a->q, s2->as<StateType>()->q, a->grasp));
    if (fraction >= 1.0) return true;
  }
  lastValid.second = fraction;
  if (lastValid.first != nullptr) si_->getStateSpace()->interpolate(s1, s2, fraction, lastValid.first);
  return false;
}

ob::SpaceInformationPtr makeManipulationSpaceInformation(const std::shared_ptr<ManipulationStateSpace>& space,
                                                         std::shared_ptr<const GraspMotionChecker> checker,
                                                         std::shared_ptr<ValidityCounts> counts) {
  auto pool = std::make_shared<GraspMotionPool>([checker] { return checker->makeContext(); });
  auto si = std::make_shared<ob::SpaceInformation>(space);
  si->setStateValidityChecker(std::make_shared<ManipulationValidityChecker>(si, pool, counts));
  si->setMotionValidator(std::make_shared<ManipulationMotionValidator>(si, pool, counts));
  si->setup();
  return si;
}

}  // namespace b4p
