// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/placement_parameters.h"

#include <array>

#include "experiments/named_values.h"
#include "planners/placement/placement_planner.h"

namespace b4p {

namespace ob = ompl::base;

namespace {

constexpr std::array<Named<PlacementSampling>, 3> kSamplings{
    {{PlacementSampling::kTreeSearch, "tree"},
     {PlacementSampling::kUniformChildren, "children"},
     {PlacementSampling::kUniformArea, "area"}}};
constexpr std::array<Named<PlacementReward>, 2> kRewards{
    {{PlacementReward::kStaged, "staged"}, {PlacementReward::kPaper, "paper"}}};

using Options = std::shared_ptr<PlacementOptions>;

template <class Value>
void declare(ob::ParamSet& parameters, const Options& options, const char* name,
             Value PlacementOptions::*member, const char* range) {
  parameters.declareParam<Value>(
      name, [options, member](Value value) { (*options).*member = value; },
      [options, member] { return (*options).*member; });
  parameters[name].setRangeSuggestion(range);
}

template <class Value, class Names>
void declareWord(ob::ParamSet& parameters, const Options& options, const char* name,
                 Value PlacementOptions::*member, const Names& names) {
  parameters.declareParam<std::string>(
      name,
      [options, member, name, &names](const std::string& word) {
        (*options).*member = valueOf(names, word, "", name);
      },
      [options, member, &names] { return nameIn(names, (*options).*member); });
  parameters[name].setRangeSuggestion(namesIn(names));
}

ob::ParamSet parametersOf(const Options& options) {
  ob::ParamSet parameters;
  declareWord(parameters, options, "sampling", &PlacementOptions::sampling, kSamplings);
  declareWord(parameters, options, "reward", &PlacementOptions::reward, kRewards);
  declare(parameters, options, "exploration", &PlacementOptions::exploration, "0.:0.01:10.");
  declare(parameters, options, "stage", &PlacementOptions::stage, "0.:0.01:1.");
  declare(parameters, options, "discount", &PlacementOptions::discount, "0.01:0.01:1.");
  declare(parameters, options, "ik_attempts", &PlacementOptions::ik_attempts, "1:1:1000");
  declare(parameters, options, "postures", &PlacementOptions::postures, "1:1:1000");
  declare(parameters, options, "pose_first", &PlacementOptions::pose_first, "0,1");
  declare(parameters, options, "hand_first", &PlacementOptions::hand_first, "0,1");
  declare(parameters, options, "prune", &PlacementOptions::prune, "0,1");
  declare(parameters, options, "take_back", &PlacementOptions::take_back, "0,1");
  return parameters;
}

}  // namespace

PlannerKind placementPlannerKind(const Options& options) {
  return {"placement",
          "ever better placements: tree search over where the object can stand, motion planning whose goals "
          "come and go, local optimisation",
          0,
          [options](const ob::SpaceInformationPtr& si) {
            auto planner = std::make_shared<PlacementPlanner>(si);
            planner->params().include(parametersOf(options));
            return planner;
          },
          {TaskKind::kPlacement}};
}

PlacementSampling placementSampling(const std::string& name, const std::string& where) {
  return valueOf(kSamplings, name, where, "--sampling");
}

std::string nameOf(PlacementSampling sampling) { return nameIn(kSamplings, sampling); }

}  // namespace b4p
