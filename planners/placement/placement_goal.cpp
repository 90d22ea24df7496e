// SPDX-License-Identifier: BSD-3-Clause
#include "planners/placement/placement_goal.h"

#include <cmath>
#include <exception>
#include <limits>
#include <new>
#include <stdexcept>
#include <utility>

#include <ompl/base/SpaceInformation.h>

#include "planners/manipulation_state_space.h"
#include "planners/placement/placement_sampler.h"
#include "planners/placement/placement_trial.h"

namespace b4p {

namespace ob = ompl::base;

namespace {

using StateType = ManipulationStateSpace::StateType;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string emptyWorld(const PlacementWorld& world) {
  if (world.armCount() <= 0) return "no arm holds the object";
  if (world.faceCount() <= 0) return "the object has no face that it can stand on";
  if (world.regions().empty()) return "there is no surface to place on";
  return {};
}

/// A state that every planner rejects.
void setOutside(const ob::SpaceInformationPtr& si, StateType* state) {
  const unsigned dof = si->getStateSpace()->as<ManipulationStateSpace>()->dof();
  for (unsigned i = 0; i < dof; ++i) state->q[i] = kInfinity;
  state->grasp = kNoGrasp;
}

}  // namespace

/// What all threads share, behind its mutex.
struct PlacementGoal::Search {
  struct Draw {
    Placement placement;
    PlacementSampler::Branch branch = 0;
    double threshold = 0.0;
    std::uint64_t seed = 0;
    std::uint64_t epoch = 0;  ///< draws from before the last seed() teach nothing
  };

  bool ended() const { return sampler == nullptr || exhausted || !problem.empty(); }

  /// False when there is nothing to draw any more.
  bool draw(const std::atomic<double>& threshold, Draw& draw) {
    const std::lock_guard<std::mutex> lock(mutex);
    if (ended()) return false;
    draw.threshold = threshold.load(std::memory_order_acquire);
    if (!sampler->draw(random, draw.threshold, draw.placement, draw.branch)) {
      exhausted = true;
      ++statistics.exhausted;
      return false;
    }
    draw.seed = random();
    draw.epoch = epoch;
    return true;
  }

  /// @return whether the draw gave a goal state
  bool learn(const Draw& draw, const PlacementOutcome& outcome, const PlacementOptions& options,
             const PlacementObjective& objective) {
    const std::lock_guard<std::mutex> lock(mutex);
    if (draw.epoch == epoch) {
      sampler->learn(draw.branch, outcome);
      countOutcome(outcome, options, statistics);
    }
    if (objective.failed()) problem = objective.problem();
    return outcome.valid() && problem.empty();
  }

  void fail(const std::string& what) {
    const std::lock_guard<std::mutex> lock(mutex);
    if (problem.empty()) problem = "testing a placement failed: " + what;
  }

  /// To be called in a handler. What the world threw ends the search; std::bad_alloc goes on.
  void failByException() {
    try {
      throw;
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& e) {
      fail(e.what());
    } catch (...) {
      fail("an exception of unknown type");
    }
  }

  std::mutex mutex;  ///< guards all that follows
  std::mt19937_64 random;
  std::unique_ptr<PlacementSampler> sampler;  ///< null where there is nothing to draw
  PlacementStatistics statistics;
  bool exhausted = false;
  std::string problem;
  std::uint64_t epoch = 0;
};

PlacementGoal::PlacementGoal(const ob::SpaceInformationPtr& si, std::shared_ptr<const PlacementWorld> world,
                             std::shared_ptr<const PlacementObjective> objective,
                             const PlacementOptions& options)
    : ob::GoalSampleableRegion(si),
      world_(std::move(world)),
      objective_(std::move(objective)),
      options_(options),
      threshold_(-kInfinity),
      contexts_([this] { return world_->makeContext(); }),
      search_(std::make_unique<Search>()) {
  if (world_ == nullptr) throw std::invalid_argument("placing needs a world");
  if (objective_ == nullptr) throw std::invalid_argument("placing needs an objective");
  if (const std::string problem = options_.problem(); !problem.empty()) throw std::invalid_argument(problem);
  const auto* space = dynamic_cast<const ManipulationStateSpace*>(si->getStateSpace().get());
  if (space == nullptr || space->dof() != world_->dof())
    throw std::invalid_argument("placing needs a manipulation state space of the arms' " +
                                std::to_string(world_->dof()) + " joints");
  setThreshold(std::numeric_limits<double>::epsilon());  // of distanceGoal(), which counts
  seed(0);
}

PlacementGoal::~PlacementGoal() = default;

void PlacementGoal::seed(std::uint64_t seed) {
  const std::string empty = emptyWorld(*world_);
  const std::lock_guard<std::mutex> lock(search_->mutex);
  search_->random.seed(seed);
  search_->sampler = empty.empty() ? makePlacementSampler(*world_, *objective_, options_) : nullptr;
  search_->statistics = {};
  search_->exhausted = false;
  search_->problem = empty;
  ++search_->epoch;
}

void PlacementGoal::setObjectiveThreshold(double threshold) {
  const std::lock_guard<std::mutex> lock(search_->mutex);
  const double before = threshold_.exchange(std::isnan(threshold) ? kInfinity : threshold);
  if (threshold < before) search_->exhausted = false;
  if (threshold > before && search_->sampler != nullptr) search_->sampler->thresholdRaised(threshold);
}

double PlacementGoal::objective(const ob::State* state) const {
  const auto* s = state->as<StateType>();
  if (s->grasp < 0 || s->grasp >= world_->armCount() || !si_->satisfiesBounds(state)) return -kInfinity;
  try {
    return objective_->value(contexts_.lease()->objectPose(s->grasp, s->q));
  } catch (...) {
    search_->failByException();
    return -kInfinity;
  }
}

bool PlacementGoal::sample(ob::State* state, unsigned attempts) const {
  auto* s = state->as<StateType>();
  try {
    const auto context = contexts_.lease();
    Search::Draw draw;
    for (unsigned i = 0; i < attempts && search_->draw(threshold_, draw); ++i) {
      const PlacementOutcome outcome = tryPlacement(*world_, *objective_, options_, *context, draw.placement,
                                                    draw.threshold, draw.seed, s->q);
      s->grasp = draw.placement.arm;
      if (search_->learn(draw, outcome, options_, *objective_)) return true;
    }
  } catch (...) {
    search_->failByException();
  }
  setOutside(si_, s);
  return false;
}

void PlacementGoal::reportReached(const ob::State* state, double value) const {
  const auto* s = state->as<StateType>();
  if (std::isnan(value) || objective(state) == -kInfinity) return;
  Placement placement;
  try {
    if (!world_->locate(contexts_.lease()->objectPose(s->grasp, s->q), placement)) return;
  } catch (...) {
    search_->failByException();
    return;
  }
  placement.arm = s->grasp;
  const std::lock_guard<std::mutex> lock(search_->mutex);
  if (search_->sampler != nullptr) search_->sampler->learnReached(placement);
}

PlacementStatistics PlacementGoal::statistics() const {
  const std::lock_guard<std::mutex> lock(search_->mutex);
  return search_->statistics;
}

std::string PlacementGoal::problem() const {
  const std::lock_guard<std::mutex> lock(search_->mutex);
  return search_->problem;
}

void PlacementGoal::sampleGoal(ob::State* state) const { sample(state, options_.attempts); }

unsigned int PlacementGoal::maxSampleCount() const {
  return couldSample() ? std::numeric_limits<unsigned int>::max() : 0;
}

bool PlacementGoal::couldSample() const {
  const std::lock_guard<std::mutex> lock(search_->mutex);
  return !search_->ended();
}

double PlacementGoal::distanceGoal(const ob::State* state) const {
  const auto* s = state->as<StateType>();
  if (s->grasp < 0 || s->grasp >= world_->armCount() || !si_->satisfiesBounds(state)) return kInfinity;
  try {
    const auto context = contexts_.lease();
    const Eigen::Isometry3d X_WO = context->objectPose(s->grasp, s->q);
    double failed = 0.0;
    if (!world_->stable(X_WO)) failed += 1.0;
    if (!context->objectFree(X_WO)) failed += 1.0;
    if (!(objective_->value(X_WO) > objectiveThreshold())) failed += 1.0;
    return failed;
  } catch (...) {
    search_->failByException();
    return kInfinity;
  }
}

bool PlacementGoal::isStartGoalPairValid(const ob::State* start, const ob::State* goal) const {
  return start->as<StateType>()->grasp == goal->as<StateType>()->grasp;
}

}  // namespace b4p
