// SPDX-License-Identifier: BSD-3-Clause
// placement_sampling [SEEDS [SECONDS [SCENE...]]]: how goal samplers do on placement scenes (all that ship).
// Two lines per scene and sampler, over SEEDS (20) seeds: processor time and draws to the first valid sample,
// and the objective reached within SECONDS (1) of processor time when each sample raises the threshold to its
// own objective.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
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

std::vector<Variant> variants() {
  const auto with = [](const std::string& name, auto change) {
    Variant variant{name, {}};
    change(variant.options);
    return variant;
  };
  return {
      with("tree search", [](PlacementOptions&) {}),
      with("uniform children", [](PlacementOptions& o) { o.sampling = PlacementSampling::kUniformChildren; }),
      with("uniform area", [](PlacementOptions& o) { o.sampling = PlacementSampling::kUniformArea; }),
      with("inverse kinematics first", [](PlacementOptions& o) { o.pose_first = false; }),
      with("no hand test", [](PlacementOptions& o) { o.hand_first = false; }),
      with("no pruning", [](PlacementOptions& o) { o.prune = false; }),
      with("pruning off, discount 0.5",
           [](PlacementOptions& o) {
             o.prune = false;
             o.discount = 0.5;
           }),
      with("discount 0.5", [](PlacementOptions& o) { o.discount = 0.5; }),
      with("one posture", [](PlacementOptions& o) { o.postures = 1; })};
}

struct Outcome {
  double first_s = 0.0;
  double first_draws = 0.0;
  double best = 0.0;
  double draws = 0.0;
};

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
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

void report(const std::string& scene, const std::string& sense, const Variant& variant,
            const std::vector<Outcome>& all) {
  std::vector<double> first_s, first_draws, best, draws;
  for (const Outcome& one : all) {
    const bool found = !std::isnan(one.first_s);
    first_s.push_back(found ? one.first_s : 1e9);
    first_draws.push_back(found ? one.first_draws : 1e9);
    best.push_back(found ? one.best : -1e9);
    draws.push_back(one.draws);
  }
  std::cout << scene << ' ' << sense << " | " << variant.name << std::fixed << " | first "
            << std::setprecision(2) << 1e3 * quantile(first_s, 0.5) << " ms ("
            << 1e3 * quantile(first_s, 0.25) << " ... " << 1e3 * quantile(first_s, 0.75) << "), "
            << std::setprecision(0) << quantile(first_draws, 0.5) << " draws | objective "
            << std::setprecision(2) << 1e3 * quantile(best, 0.5) << " mm (" << 1e3 * quantile(best, 0.25)
            << " ... " << 1e3 * quantile(best, 0.75) << ") | " << std::setprecision(0) << quantile(draws, 0.5)
            << " draws" << std::endl;
}

void measure(const std::string& name, int seeds, double limit_s) {
  const Scene scene = loadPlacementScene(name);
  for (const auto& [goal, sense] :
       {std::pair(ClearanceGoal::kLargest, "max"), {ClearanceGoal::kSmallest, "min"}}) {
    Scene task = scene;
    task.place->objective = goal;
    const PlacementProblem problem = makePlacementProblem(task);
    for (const Variant& variant : variants()) {
      std::vector<Outcome> all;
      for (int seed = 1; seed <= seeds; ++seed)
        all.push_back(runOnce(problem, variant.options, static_cast<std::uint64_t>(seed), limit_s));
      report(scene.name, sense, variant, all);
    }
  }
}

int run(int argc, char** argv) {
  ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
  const int seeds = argc > 1 ? std::stoi(argv[1]) : 20;
  const double limit_s = argc > 2 ? std::stod(argv[2]) : 1.0;
  std::vector<std::string> scenes(argv + std::min(argc, 3), argv + argc);
  if (scenes.empty()) scenes = placementSceneNames();
  try {
    for (const std::string& scene : scenes) measure(scene, seeds, limit_s);
  } catch (const InputError& e) {
    std::cerr << "placement_sampling: " << e.what() << std::endl;
    return 2;
  }
  return 0;
}

}  // namespace
}  // namespace b4p

int main(int argc, char** argv) { return b4p::run(argc, argv); }
