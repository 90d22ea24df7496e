// SPDX-License-Identifier: BSD-3-Clause
// What the parts of B4P's default search cost on the shipped scenes, and how often they allocate:
// SCENE/step/NODES is one step of a worker whose forests have NODES nodes (up to twice as many), with a
// grasp that has roots at both ends and, as far as is known, no path: nothing ends the search. SCENE/pick
// draws a grasp for a placement, SCENE/place asks for a place root of a known grasp (Eq. 3), SCENE/retreat
// goes one step straight out of a pick.
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <ompl/base/Planner.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "experiments/benchmarks/counted_allocations.h"
#include "experiments/certification/certificate.h"
#include "experiments/problem.h"
#include "planners/b4p/search.h"
#include "planners/b4p/worker.h"
#include "planners/place_goal.h"
#include "planners/processor_time.h"

namespace b4p {
namespace {

constexpr double kGrowth = 2.0;
constexpr double kPatience_s = 60.0;

/// A grasp of a scene's certificate with roots at both ends and no known path.
Grasp hopelessGrasp(const Scene& scene) {
  for (const GraspRecord& record : readCertificate(certificateFile(scene)).grasps)
    if (record.placements_found > 0 && record.status != GraspStatus::kCompatible) return record.grasp;
  throw std::runtime_error(scene.name + " has no such grasp");
}

/// Never content with a path.
class RefusingGoal : public PlaceGoal {
 public:
  using PlaceGoal::PlaceGoal;
  bool isStartGoalPairValid(const ompl::base::State*, const ompl::base::State*) const override {
    return false;
  }
};

/// A search whose forests have grown to a number of nodes; made again when they have outgrown it.
class GrownSearch {
 public:
  GrownSearch(const std::string& scene, std::uint64_t nodes)
      : open_(makeProblem(loadScene(scene))), grasp_(hopelessGrasp(open_.scene)), nodes_(nodes) {}

  bool fits() const {
    return worker_ && static_cast<double>(statistics_.nodes) < kGrowth * static_cast<double>(nodes_);
  }

  /// False when they have not grown so far within a minute.
  bool make() {
    worker_.reset();
    search_.reset();
    statistics_.reset();
    problem_ = std::make_unique<Problem>(withGraspsOnly(open_, {grasp_}));
    goal_ = std::make_unique<RefusingGoal>(problem_->si, problem_->region);
    search_ = std::make_unique<Search>(
        SearchProblem{problem_->si, goal_.get(), problem_->region.get(), inputs_, statistics_},
        B4PParameters());
    worker_ = makeWorker(*search_, ++seed_);
    const double begin_s = threadTime_s();
    while (statistics_.nodes < nodes_ && threadTime_s() - begin_s < kPatience_s) worker_->step();
    return statistics_.nodes >= nodes_;
  }

  void step() { worker_->step(); }

 private:
  Problem open_;
  Grasp grasp_;
  std::uint64_t nodes_;
  std::uint64_t seed_ = 0;
  Statistics statistics_;
  ompl::base::PlannerInputStates inputs_;
  std::unique_ptr<Problem> problem_;
  std::unique_ptr<RefusingGoal> goal_;
  std::unique_ptr<Search> search_;
  std::unique_ptr<Worker> worker_;
};

/// Counts allocations over a loop, as a figure per iteration.
class AllocationCount {
 public:
  explicit AllocationCount(benchmark::State& state) : state_(state), before_(allocations()) {}
  ~AllocationCount() {
    state_.counters["allocations"] =
        static_cast<double>(allocations() - before_ - elsewhere_) / static_cast<double>(state_.iterations());
  }
  /// Does something whose allocations do not count, outside the time measured.
  template <class Work>
  void aside(const Work& work) {
    state_.PauseTiming();
    const std::uint64_t begin = allocations();
    work();
    elsewhere_ += allocations() - begin;
    state_.ResumeTiming();
  }

 private:
  benchmark::State& state_;
  std::uint64_t before_;
  std::uint64_t elsewhere_ = 0;
};

void stepWorker(benchmark::State& state, GrownSearch& search) {
  if (!search.fits() && !search.make()) return state.SkipWithError("the forests do not grow so far");
  AllocationCount count(state);
  for (auto _ : state) {
    search.step();
    if (!search.fits()) count.aside([&search] { search.make(); });
  }
}

/// A scene with a pick.
struct Picked {
  explicit Picked(const std::string& scene)
      : problem(makeProblem(loadScene(scene))),
        context(problem.region->makeSceneContext(1)),
        q(static_cast<std::size_t>(problem.robot->dof())),
        next(q) {
    while (!context->samplePick(q.data(), grasp)) {
    }
  }

  Problem problem;
  std::unique_ptr<SceneRegionContext> context;
  std::vector<double> q, next;
  GraspId grasp = kNoGrasp;
};

void drawPick(benchmark::State& state, const std::string& scene) {
  Picked picked(scene);
  const PlacementId placement = picked.context->samplePlacement();
  std::int64_t found = 0;
  AllocationCount count(state);
  for (auto _ : state) found += picked.context->samplePickFor(placement, picked.next.data(), picked.grasp);
  state.counters["found"] = static_cast<double>(found) / static_cast<double>(state.iterations());
}

void drawPlaceRoot(benchmark::State& state, const std::string& scene) {
  Picked picked(scene);
  std::int64_t found = 0;
  AllocationCount count(state);
  for (auto _ : state)
    found += picked.context->placeRoot(picked.context->samplePlacement(), picked.grasp, picked.next.data());
  state.counters["found"] = static_cast<double>(found) / static_cast<double>(state.iterations());
}

void retreatOnce(benchmark::State& state, const std::string& scene) {
  Picked picked(scene);
  int direction = 0;
  AllocationCount count(state);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        picked.context->retreat(picked.q.data(), picked.grasp, direction, picked.next.data()));
    direction = (direction + 1) % picked.context->retreatDirections();
  }
}

void registerAll(const std::string& scene) {
  for (const int nodes : {1000, 10000, 100000}) {
    const auto search = std::make_shared<std::unique_ptr<GrownSearch>>();
    benchmark::RegisterBenchmark(
        (scene + "/step/" + std::to_string(nodes)).c_str(), [=](benchmark::State& state) {
          if (!*search) *search = std::make_unique<GrownSearch>(scene, static_cast<std::uint64_t>(nodes));
          stepWorker(state, **search);
        });
  }
  benchmark::RegisterBenchmark((scene + "/pick").c_str(), drawPick, scene);
  benchmark::RegisterBenchmark((scene + "/place").c_str(), drawPlaceRoot, scene);
  benchmark::RegisterBenchmark((scene + "/retreat").c_str(), retreatOnce, scene);
}

}  // namespace
}  // namespace b4p

int main(int argc, char** argv) {
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(1);
  for (const char* scene : {"grocery", "stick", "maze"}) b4p::registerAll(scene);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
