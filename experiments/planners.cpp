// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/planners.h"

#include <cmath>
#include <exception>
#include <optional>
#include <utility>

#include <ompl/base/GenericParam.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Exception.h>

#include "experiments/placement/placement_parameters.h"
#include "planners/b4p/b4p_planner.h"
#include "planners/baselines/rrt_individual.h"
#include "planners/baselines/rrt_restart.h"
#include "planners/baselines/rrt_shared.h"
#include "planners/placement/redirectable_rrt_connect.h"
#include "planners/reach/bik_rrt.h"
#include "planners/reach/ik_rrt.h"
#include "planners/reach/jplus_rrt.h"
#include "robots/input_error.h"

namespace b4p {

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

/// Picks that an ordinary planner starts from where grasps form a continuum.
constexpr int kManyStarts = 64;

const std::set<TaskKind> kBothTasks{TaskKind::kPickPlace, TaskKind::kReach};

constexpr const char* kThreads = "threads";
constexpr const char* kPaper = "paper";

ob::PlannerPtr makePaperB4P(const ob::SpaceInformationPtr& si) {
  auto planner = std::make_shared<B4P>(si);
  planner->params().setParam("paper", "1");
  planner->setName("B4P-paper");
  return planner;
}

template <class Planner>
ob::PlannerPtr make(const ob::SpaceInformationPtr& si) {
  return std::make_shared<Planner>(si);
}

/// The number that a whole text is; none for a word.
std::optional<double> numberIn(const std::string& text) {
  try {
    std::size_t used = 0;
    const double number = std::stod(text, &used);
    if (used == text.size()) return number;
  } catch (const std::exception&) {
  }
  return std::nullopt;
}

/// Whether the planner takes the value and holds it afterwards. OMPL's own parsing takes "12abc" for 12 and
/// "-1" for a very large unsigned number; reading the value back (numbers with the six digits that OMPL
/// writes) finds both.
bool set(ob::ParamSet& parameters, const std::string& name, const std::string& value) {
  constexpr double kDigitsKept = 1e-5;
  const std::string given = value == "true" ? "1" : value == "false" ? "0" : value;
  const std::optional<double> wanted = numberIn(given);
  if (wanted && !std::isfinite(*wanted)) return false;
  try {
    std::string held;
    if (!parameters.setParam(name, given) || !parameters.getParam(name, held)) return false;
    const std::optional<double> number = numberIn(held);
    return wanted && number ? std::abs(*number - *wanted) <= kDigitsKept * std::abs(*wanted) : held == given;
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace

PlannerCatalogue PlannerCatalogue::standard() {
  PlannerCatalogue catalogue;
  catalogue.add({"b4p",
                 "B4P, default search: roots without limit, every grasp served in turn, connections across "
                 "grasps repaired; when reaching, all threads one bidirectional search",
                 0, make<B4P>, kBothTasks});
  catalogue.add({"b4p-paper", "B4P as printed: a fixed number of roots, one forest per side for all grasps",
                 0, makePaperB4P});
  catalogue.add(
      {"rrt-individual",
       "the paper's baseline: each thread a bidirectional RRT with one grasp and one placement of its "
       "own, never changed",
       0, make<RRTIndividual>});
  catalogue.add({"rrt-shared",
                 "the paper's baseline: all threads one bidirectional RRT with one grasp and one placement, "
                 "restarted with another grasp after a time limit",
                 0, make<RRTShared>});
  catalogue.add(
      {"rrt-restart",
       "a race of RRT-Connects over pairs of grasp and placement, in slices that grow; none is dropped", 0,
       make<RRTRestart>});
  catalogue.add({"redirectable-rrtconnect",
                 "RRT-Connect per grasp, in slices, whose goals can be added and removed while it keeps its "
                 "trees",
                 0, make<RedirectableRRTConnect>});
  catalogue.add(
      {"rrtconnect",
       "OMPL's RRTConnect on joints x grasp: all picks as starts, placements as goals; when reaching, "
       "configurations at grasps by inverse kinematics as goals",
       kManyStarts, make<og::RRTConnect>, kBothTasks});
  const auto add_reaching = [&catalogue](const char* name, const char* description, const auto& made) {
    catalogue.add({name, description, 0, made, {TaskKind::kReach}});
  };
  add_reaching("jplus-rrt",
               "J+-RRT: a tree led to grasps by steps of the Jacobian's pseudo-inverse, without "
               "inverse kinematics",
               make<JPlusRRT>);
  add_reaching("ik-rrt", "IK-RRT: grasps one after the other, inverse kinematics and an RRT to what it finds",
               make<IKRRT>);
  add_reaching("bik-rrt", "BIK-RRT: bidirectional, goal trees added online by inverse kinematics",
               make<BIKRRT>);
  add_reaching("rrt", "OMPL's RRT, goals by inverse kinematics", make<og::RRT>);
  add_reaching("rrtstar", "OMPL's RRTstar, goals by inverse kinematics, until its first exact path",
               make<og::RRTstar>);
  catalogue.add(placementPlannerKind(std::make_shared<PlacementOptions>()));
  return catalogue;
}

const PlannerKind& findFitting(const PlannerCatalogue& catalogue, const std::string& name, const Scene& scene,
                               const std::string& where) {
  const PlannerKind& kind = catalogue.find(name, where);
  if (kind.tasks.count(scene.kind()) == 0)
    throw InputError(where, "",
                     "'" + name + "' is no planner for a task of " + nameOf(scene.kind()) + " such as '" +
                         scene.name + "'; there are: " + catalogue.namesFor(scene.kind()));
  return kind;
}

const PlannerKind& PlannerCatalogue::find(const std::string& name, const std::string& where) const {
  std::string known;
  for (const PlannerKind& kind : kinds_) {
    if (kind.name == name) return kind;
    known += (known.empty() ? "" : ", ") + kind.name;
  }
  throw InputError(where, "", "no planner is called '" + name + "'; there are: " + known);
}

std::string PlannerCatalogue::namesFor(TaskKind task) const {
  std::string names;
  for (const PlannerKind& kind : kinds_)
    if (kind.tasks.count(task) > 0) names += (names.empty() ? "" : ", ") + kind.name;
  return names;
}

ob::PlannerPtr makePlanner(const PlannerKind& kind, const PlannerParameters& parameters, unsigned threads,
                           const ob::SpaceInformationPtr& si, const std::string& where) {
  ob::PlannerPtr planner = kind.make(si);
  ob::ParamSet& known = planner->params();
  if (known.hasParam(kThreads)) {
    if (!set(known, kThreads, std::to_string(threads)))
      throw InputError(where, kThreads, kind.name + " does not take " + std::to_string(threads) + " threads");
  } else if (threads != 1) {
    throw InputError(where, kThreads,
                     kind.name + " runs on one thread (" + std::to_string(threads) + " asked for)");
  }
  for (const auto& [name, value] : parameters) {
    if (name == kPaper && dynamic_cast<const B4P*>(planner.get()) != nullptr)
      throw InputError(where, name, "is said by the planner's name, b4p or b4p-paper, not by a parameter");
    if (name == kThreads) throw InputError(where, name, "is an option of its own, not a parameter");
    if (!known.hasParam(name)) throw InputError(where, name, kind.name + " has no such parameter");
    if (!set(known, name, value))
      throw InputError(where, name, kind.name + " does not take the value '" + value + "'");
  }
  return planner;
}

}  // namespace b4p
