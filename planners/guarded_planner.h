// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include <ompl/base/Planner.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/Exception.h>

#include "planners/b4p/growth.h"

namespace b4p {

/// What all planners of this package have in common: exact solutions only, and a solve() that never throws
/// but for a missing problem definition, goal or start: an exception out of the problem's own functions ends
/// in PlannerStatus::CRASH.
class GuardedPlanner : public ompl::base::Planner {
 public:
  using Planner::solve;
  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& ptc) override;

  /// What ended the last solve() with PlannerStatus::CRASH; empty when nothing did.
  const std::string& lastError() const { return last_error_; }

 protected:
  GuardedPlanner(const ompl::base::SpaceInformationPtr& si, const std::string& name);

  /// solve() after the checks; may throw.
  virtual ompl::base::PlannerStatus search(const ompl::base::PlannerTerminationCondition& ptc) = 0;

  /// @param count  lives as long as the planner
  void declareProgress(const std::string& name, const std::atomic<std::uint64_t>& count);

  void addSolution(const ompl::geometric::PathGeometric& path);

  /// checkValidity() of a planner that draws picks from a PlaceGoal by itself: there, start states may be
  /// missing.
  void checkValidityOfDrawnStarts();

  /// False when the goal's states have all been taken.
  bool mayGiveMore(const ompl::base::GoalSampleableRegion& goal) const;

  /// The problem's next goal state, waiting for goals that are sampled meanwhile; nullptr when there is none
  /// for now.
  const ompl::base::State* awaitGoal(const ompl::base::PlannerTerminationCondition& ptc);

 private:
  std::string last_error_;
};

/// Tags of vertices by the side of their tree.
constexpr int kPickTag = 1, kPlaceTag = 2;

/// Adds a node with the edge from its parent. Edges point from pick to place.
void addTo(ompl::base::PlannerData& data, const Node& node);

/// Adds the edge over a junction, whose nodes have been added before.
void addTo(ompl::base::PlannerData& data, const Junction& junction);

/// A planner whose OMPL parameters are the fields of a plain struct.
/// @tparam Base  a GuardedPlanner
/// @tparam Parameters  has problem(): what is out of range, "" when nothing is
template <class Base, class Parameters>
class WithParameters : public Base {
 public:
  const Parameters& parameters() const { return parameters_; }

  /// @throws ompl::Exception naming what is out of range; nothing changes then.
  void setParameters(const Parameters& parameters) {
    const std::string problem = parameters.problem();
    if (!problem.empty()) throw ompl::Exception(this->getName(), problem);
    parameters_ = parameters;
  }

 protected:
  using Base::Base;

  /// @tparam Owner  Parameters or a base of it
  template <class Value, class Owner>
  void declare(const std::string& name, Value Owner::*field, const std::string& range) {
    const auto set = [this, field](Value value) {
      Parameters changed = parameters_;
      changed.*field = value;
      setParameters(changed);
    };
    this->params_.template declareParam<Value>(name, set, [this, field] { return parameters_.*field; });
    this->params_[name].setRangeSuggestion(range);
  }

 private:
  Parameters parameters_;
};

}  // namespace b4p
