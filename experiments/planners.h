// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <ompl/base/Planner.h>

#include "experiments/scene.h"

namespace b4p {

/// A planner as the command line and experiment files name it.
struct PlannerKind {
  std::string name;
  std::string description;
  /// How many picks a problem of pick and place gets as start states. 0 for planners that draw picks by
  /// themselves.
  int start_states = 0;
  std::function<ompl::base::PlannerPtr(const ompl::base::SpaceInformationPtr&)> make;
  std::set<TaskKind> tasks = {TaskKind::kPickPlace};  ///< what it is made for
};

using PlannerParameters = std::map<std::string, std::string>;

/// The planners there are, in the order they are listed.
class PlannerCatalogue {
 public:
  /// b4p, b4p-paper, rrt-individual, rrt-shared, rrt-restart, redirectable-rrtconnect, rrtconnect; for
  /// reaching b4p, rrtconnect, jplus-rrt, ik-rrt, bik-rrt, rrt, rrtstar; for placement placement.
  static PlannerCatalogue standard();

  void add(PlannerKind kind) { kinds_.push_back(std::move(kind)); }
  const std::vector<PlannerKind>& kinds() const { return kinds_; }

  /// @param where  named in errors: the option or file and key
  /// @throws InputError listing the names there are
  const PlannerKind& find(const std::string& name, const std::string& where) const;

  /// The names of those made for a kind of task, separated by commas.
  std::string namesFor(TaskKind task) const;

 private:
  std::vector<PlannerKind> kinds_;
};

/// The planner of that name, which has to be made for the scene's kind of task.
/// @throws InputError otherwise
const PlannerKind& findFitting(const PlannerCatalogue& catalogue, const std::string& name, const Scene& scene,
                               const std::string& where);

/// What a parameter of one of this package's planners means, with its unit; "" for those of others.
std::string parameterMeaning(const ompl::base::Planner& planner, const std::string& name);

/// Makes a planner and sets its parameters.
/// @param threads  >= 1; the planner's parameter `threads` where it has one
/// @throws InputError for an unknown parameter, B4P's `paper` (which the planner's name says), a value that
/// the planner does not take, or several threads for a planner of one
ompl::base::PlannerPtr makePlanner(const PlannerKind& kind, const PlannerParameters& parameters,
                                   unsigned threads, const ompl::base::SpaceInformationPtr& si,
                                   const std::string& where);

}  // namespace b4p
