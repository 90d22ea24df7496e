// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/arm_validity.h"

#include <algorithm>
#include <utility>

#include <ompl/base/MotionValidator.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "planners/context_pool.h"

namespace b4p {

namespace ob = ompl::base;

namespace {

using Pool = ContextPool<CollisionContext>;

const double* valuesOf(const ob::State* state) {
  return state->as<ob::RealVectorStateSpace::StateType>()->values;
}

/// What both validators ask.
struct Arm {
  std::shared_ptr<const CollisionChecker> checker;
  std::optional<Grasp> grasp;
  Pool pool{[this] { return checker->makeContext(); }};

  const Grasp* held() const { return grasp ? &*grasp : nullptr; }
};

class ArmValidityChecker : public ob::StateValidityChecker {
 public:
  ArmValidityChecker(const ob::SpaceInformationPtr& si, std::shared_ptr<Arm> arm)
      : ob::StateValidityChecker(si), arm_(std::move(arm)) {}

  bool isValid(const ob::State* state) const override {
    return si_->satisfiesBounds(state) && arm_->pool.lease()->isFree(valuesOf(state), arm_->held());
  }

 private:
  std::shared_ptr<Arm> arm_;
};

class ArmMotionValidator : public ob::MotionValidator {
 public:
  ArmMotionValidator(const ob::SpaceInformationPtr& si, std::shared_ptr<Arm> arm)
      : ob::MotionValidator(si), arm_(std::move(arm)) {}

  bool checkMotion(const ob::State* s1, const ob::State* s2) const override {
    return si_->satisfiesBounds(s1) && si_->satisfiesBounds(s2) &&
           arm_->pool.lease()->isEdgeFree(valuesOf(s1), valuesOf(s2), arm_->held());
  }

  bool checkMotion(const ob::State* s1, const ob::State* s2,
                   std::pair<ob::State*, double>& lastValid) const override {
    double fraction = 0.0;
    if (si_->satisfiesBounds(s1) && si_->satisfiesBounds(s2))
      fraction = std::max(0.0, arm_->pool.lease()->freeFraction(valuesOf(s1), valuesOf(s2), arm_->held()));
    if (fraction >= 1.0) return true;
    lastValid.second = fraction;
    if (lastValid.first != nullptr) si_->getStateSpace()->interpolate(s1, s2, fraction, lastValid.first);
    return false;
  }

 private:
  std::shared_ptr<Arm> arm_;
};

}  // namespace

ob::SpaceInformationPtr makeArmSpaceInformation(std::shared_ptr<const CollisionChecker> checker,
                                                const std::optional<Grasp>& held) {
  const Manipulator& robot = *checker->problem().robot;
  const auto dof = static_cast<unsigned>(robot.dof());
  ob::RealVectorBounds bounds(dof);
  for (unsigned i = 0; i < dof; ++i) {
    bounds.setLow(i, robot.lower()[i]);
    bounds.setHigh(i, robot.upper()[i]);
  }
  const auto space = std::make_shared<ob::RealVectorStateSpace>(dof);
  space->setBounds(bounds);
  auto arm = std::make_shared<Arm>();
  arm->checker = std::move(checker);
  arm->grasp = held;
  auto si = std::make_shared<ob::SpaceInformation>(space);
  si->setStateValidityChecker(std::make_shared<ArmValidityChecker>(si, arm));
  si->setMotionValidator(std::make_shared<ArmMotionValidator>(si, arm));
  si->setup();
  return si;
}

}  // namespace b4p
