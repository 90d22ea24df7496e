// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/hand_sieve.h"

#include <algorithm>
#include <array>

namespace b4p {
namespace {

constexpr std::size_t kAtOnce = 16;
constexpr int kRounds = 4;
/// A straight way of this many steps leads out.
constexpr int kWayOutSteps = 4;
/// In one of so many calls a way out is not asked for.
constexpr int kAnyOneIn = 4;

}  // namespace

std::shared_ptr<const CollisionChecker> HandSieve::makeChecker(const CollisionProblem& problem,
                                                               const CollisionChecker& like) {
  CollisionProblem empty_handed = problem;
  empty_handed.object.clear();
  return FloatingBody::makeChecker(empty_handed, FloatingBody::Parts::kGripper, like);
}

HandSieve::HandSieve(const GraspSampler& sampler, const CollisionChecker& bare_hands, FloatingBody& gripper,
                     Retreat& retreat)
    : sampler_(sampler), bare_hands_(bare_hands), gripper_(gripper), retreat_(retreat) {}

std::optional<Grasp> HandSieve::draw(const Eigen::Isometry3d& X_WO, std::mt19937_64& random) {
  const bool any = std::uniform_int_distribution<int>(1, kAnyOneIn)(random) == 1;
  std::optional<Grasp> boxed_in;
  for (int round = 0; round < kRounds; ++round) {
    drawn_.clear();
    while (drawn_.size() < kAtOnce) drawn_.push_back(sampler_.sample(random));
    sift(X_WO);
    for (std::size_t i = 0; i < kAtOnce; ++i) {
      const Eigen::Isometry3d X_WT = X_WO * drawn_[i].X_OT;
      if (!fits_[i] || !gripper_.isFree(X_WT, drawn_[i])) continue;
      if (any || leaves(X_WT, drawn_[i])) return drawn_[i];
      boxed_in = drawn_[i];
    }
  }
  return boxed_in;
}

// Hands that open alike are looked at together.
void HandSieve::sift(const Eigen::Isometry3d& X_WO) {
  fits_.assign(kAtOnce, false);
  std::array<bool, kAtOnce> done{};
  for (std::size_t first = 0; first < kAtOnce; ++first) {
    if (done[first]) continue;
    alike_.clear();
    X_WT_.clear();
    for (std::size_t i = first; i < kAtOnce; ++i) {
      if (drawn_[i].opening_m != drawn_[first].opening_m) continue;
      done[i] = true;
      alike_.push_back(i);
      X_WT_.push_back(X_WO * drawn_[i].X_OT);
    }
    Grasp nothing;
    nothing.opening_m = drawn_[first].opening_m;
    bare_hands_.areFree(X_WT_, nothing, free_);
    for (std::size_t i = 0; i < alike_.size(); ++i) fits_[alike_[i]] = free_[i];
  }
}

bool HandSieve::leaves(const Eigen::Isometry3d& X_WT, const Grasp& grasp) {
  std::array<int, Retreat::kDirections> reach;
  retreat_.handReach(X_WT, grasp, kWayOutSteps, reach.data());
  return *std::max_element(reach.begin(), reach.end()) == kWayOutSteps;
}

}  // namespace b4p
