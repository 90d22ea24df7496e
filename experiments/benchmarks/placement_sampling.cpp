// SPDX-License-Identifier: BSD-3-Clause
// placement_sampling samplers|switches [SEEDS [SECONDS [SCENE...]]]: how goal samplers, or the tree search
// with one switch changed at a time, do on placement scenes (all that ship). One line per scene, objective
// and variant, over SEEDS (20) seeds: median and quartiles of processor time and draws to the first valid
// sample, and of the objective reached within SECONDS (1) of processor time when each sample raises the
// threshold to its own objective.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <ompl/base/ScopedState.h>
#include <ompl/util/Console.h>

#include "experiments/placement/placement_file.h"
#include "experiments/placement/placement_problem.h"
#include "planners/processor_time.h"
#include "robots/input_error.h"

namespace b4p {
namespace {

struct Variant {
  std::string name;
  PlacementOptions options;
};

Variant variant(const std::string& name, void (*change)(PlacementOptions&)) {
  Variant made{name, {}};
  change(made.options);
  return made;
}

std::vector<Variant> samplers() {
  return {variant("tree search", [](PlacementOptions&) {}),
          variant("uniform children",
                  [](PlacementOptions& o) { o.sampling = PlacementSampling::kUniformChildren; }),
          variant("uniform area", [](PlacementOptions& o) { o.sampling = PlacementSampling::kUniformArea; }),
          variant("tree search as printed", [](PlacementOptions& o) {
            o.reward = PlacementReward::kPaper;
            o.take_back = o.prune = false;
          })};
}

std::vector<Variant> switches() {
  return {variant("as it is", [](PlacementOptions&) {}),
          variant("inverse kinematics first", [](PlacementOptions& o) { o.pose_first = false; }),
          variant("no hand test", [](PlacementOptions& o) { o.hand_first = false; }),
          variant("pruning", [](PlacementOptions& o) { o.prune = true; }),
          variant("paper's rewards", [](PlacementOptions& o) { o.reward = PlacementReward::kPaper; }),
          variant("stage 1/4", [](PlacementOptions& o) { o.stage = 1.0 / 4.0; }),
          variant("stage 1/64", [](PlacementOptions& o) { o.stage = 1.0 / 64.0; }),
          variant("stage 0", [](PlacementOptions& o) { o.stage = 0.0; }),
          variant("c 0.1", [](PlacementOptions& o) { o.exploration = 0.1; }),
          variant("rewards taken back", [](PlacementOptions& o) { o.take_back = true; }),
          variant("discount 0.5", [](PlacementOptions& o) { o.discount = 0.5; }),
          variant("one posture", [](PlacementOptions& o) { o.postures = 1; }),
          variant("six postures", [](PlacementOptions& o) { o.postures = 6; })};
}

struct Outcome {
  double first_s = 0.0;
  double first_draws = 0.0;
  double best = 0.0;
  double draws = 0.0;
};

/// Median and quartiles; a run that found nothing is the worst.
std::string quartiles(std::vector<double> values, bool more_is_better, int decimals) {
  const double worst = (more_is_better ? -1.0 : 1.0) * std::numeric_limits<double>::infinity();
  for (double& value : values)
    if (std::isnan(value)) value = worst;
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    const double value =
        values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
    std::ostringstream text;
    text << std::fixed << std::setprecision(decimals) << value;
    return std::isinf(value) ? std::string("none") : text.str();
  };
  return at(0.5) + " (" + at(0.25) + " ... " + at(0.75) + ")";
}

Outcome runOnce(const PlacementProblem& problem, const PlacementOptions& options, std::uint64_t seed,
                double limit_s) {
  PlacementGoal goal(problem.si, problem.world, problem.objective, options);
  goal.seed(seed);
  ompl::base::ScopedState<ManipulationStateSpace> state(problem.space);
  Outcome outcome;
  bool found = false;
  const double begin = threadTime_s();
  const auto spent = [&] { return threadTime_s() - begin; };
  while (spent() < limit_s && goal.couldSample()) {
    if (!goal.sample(state.get(), 20)) continue;
    if (!found) {
      outcome.first_s = spent();
      outcome.first_draws = static_cast<double>(goal.statistics().draws);
      found = true;
    }
    outcome.best = goal.objective(state.get());
    goal.setObjectiveThreshold(outcome.best);
  }
  if (!found) outcome.first_s = outcome.first_draws = outcome.best = std::nan("");
  outcome.draws = static_cast<double>(goal.statistics().draws);
  return outcome;
}

void report(const std::string& task, const Variant& one, const std::vector<Outcome>& all) {
  const auto column = [&](auto value) {
    std::vector<double> values;
    std::transform(all.begin(), all.end(), std::back_inserter(values), value);
    return values;
  };
  std::cout << task << " | " << one.name << " | first "
            << quartiles(column([](const Outcome& o) { return 1e3 * o.first_s; }), false, 2) << " ms, "
            << quartiles(column([](const Outcome& o) { return o.first_draws; }), false, 0) << " draws | best "
            << quartiles(column([](const Outcome& o) { return 1e3 * o.best; }), true, 2) << " mm | "
            << quartiles(column([](const Outcome& o) { return o.draws; }), false, 0) << " draws in all"
            << std::endl;
}

void measure(const std::string& name, const std::vector<Variant>& variants, int seeds, double limit_s) {
  const Scene scene = loadPlacementScene(name);
  for (const auto& [goal, sense] :
       {std::pair(ClearanceGoal::kLargest, "max"), {ClearanceGoal::kSmallest, "min"}}) {
    Scene task = scene;
    task.placing().objective = goal;
    const PlacementProblem problem = makePlacementProblem(task);
    for (const Variant& one : variants) {
      std::vector<Outcome> all;
      for (int seed = 1; seed <= seeds; ++seed)
        all.push_back(runOnce(problem, one.options, static_cast<std::uint64_t>(seed), limit_s));
      report(scene.name + ' ' + sense, one, all);
    }
  }
}

int run(int argc, char** argv) {
  ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
  const std::string what = argc > 1 ? argv[1] : "";
  if (what != "samplers" && what != "switches") {
    std::cerr << "placement_sampling samplers|switches [SEEDS [SECONDS [SCENE...]]]" << std::endl;
    return 2;
  }
  const int seeds = argc > 2 ? std::stoi(argv[2]) : 20;
  const double limit_s = argc > 3 ? std::stod(argv[3]) : 1.0;
  std::vector<std::string> scenes(argv + std::min(argc, 4), argv + argc);
  if (scenes.empty()) scenes = placementSceneNames();
  try {
    for (const std::string& scene : scenes)
      measure(scene, what == "samplers" ? samplers() : switches(), seeds, limit_s);
  } catch (const InputError& e) {
    std::cerr << "placement_sampling: " << e.what() << std::endl;
    return 2;
  }
  return 0;
}

}  // namespace
}  // namespace b4p

int main(int argc, char** argv) { return b4p::run(argc, argv); }
