// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/certification/single_grasp_plan.h"

#include <algorithm>
#include <memory>
#include <random>

#include <ompl/base/ScopedState.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include "experiments/interrupt.h"
#include "experiments/query.h"
#include "planners/processor_time.h"

namespace b4p {

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

enum Stream : std::uint64_t { kSampleStream, kGoalStream };

/// Configurations uniform over the joint limits, held with grasp 0. OMPL's own samplers take their seeds from
/// a generator that all threads share.
class SeededSampler : public ob::StateSampler {
 public:
  SeededSampler(const ManipulationStateSpace& space, std::uint64_t seed)
      : ob::StateSampler(&space), bounds_(space.bounds()), random_(seed) {}

  void sampleUniform(ob::State* state) override {
    auto* s = state->as<ManipulationStateSpace::StateType>();
    for (std::size_t i = 0; i < bounds_.low.size(); ++i)
      s->q[i] = std::uniform_real_distribution<double>(bounds_.low[i], bounds_.high[i])(random_);
    s->grasp = 0;
  }

  // RRTConnect asks for neither.
  void sampleUniformNear(ob::State* state, const ob::State*, double) override { sampleUniform(state); }
  void sampleGaussian(ob::State* state, const ob::State*, double) override { sampleUniform(state); }

 private:
  ob::RealVectorBounds bounds_;
  std::mt19937_64 random_;
};

}  // namespace

PlanResult planWithOneGrasp(Problem& problem, const std::vector<std::vector<double>>& picks,
                            std::uint64_t seed, double effort_s) {
  problem.space->setStateSamplerAllocator([seed](const ob::StateSpace* space) {
    return std::make_shared<SeededSampler>(*space->as<ManipulationStateSpace>(),
                                           derivedSeed(seed, kSampleStream));
  });
  problem.goal->seed(derivedSeed(seed, kGoalStream));
  ob::ScopedState<ManipulationStateSpace> start(problem.space);
  start->grasp = 0;
  for (const std::vector<double>& pick : picks) {
    std::copy(pick.begin(), pick.end(), start->q);
    problem.pdef->addStartState(start);
  }

  og::RRTConnect planner(problem.si);
  // OMPL's own step is a fifth of the space's extent, the distance between grasps included: too long for
  // narrow passages.
  constexpr double kStepsAcross = 25.0;
  planner.setRange(problem.space->jointExtent() / kStepsAcross);
  planner.setProblemDefinition(problem.pdef);
  planner.setup();
  const double begin_s = threadTime_s();
  const ob::PlannerStatus status = planner.solve(ob::PlannerTerminationCondition(
      [end_s = begin_s + effort_s] { return threadTime_s() >= end_s || interrupted(); }));

  PlanResult result = pathResult(problem, status);
  result.scene = problem.scene.name;
  result.planner = "rrtconnect";
  planner.params().getParams(result.parameters);
  result.seed = seed;
  result.time_limit_s = effort_s;
  result.planning_time_s = threadTime_s() - begin_s;
  return result;
}

}  // namespace b4p
