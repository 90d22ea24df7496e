// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/sampled_context.h"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace b4p {

SampledContext::SampledContext(std::shared_ptr<const FclWorld> world)
    : pieces_(std::move(world)), q_(static_cast<std::size_t>(robot().dof())) {}

bool SampledContext::isFree(const double* q, const Grasp* held) {
  requireFinite(q);
  ++states_asked_;
  hold(held);
  return legal(q) && stateFree(q);
}

void SampledContext::areFree(const double* q, int count, const Grasp* held, bool* free) {
  for (int i = 0; i < count; ++i) free[i] = isFree(q + i * robot().dof(), held);
}

bool SampledContext::isEdgeFree(const double* q1, const double* q2, const Grasp* held) {
  requireFinite(q1);
  requireFinite(q2);
  hold(held);
  return isLegalEdgeFree(q1, q2);
}

bool SampledContext::isLegalEdgeFree(const double* q1, const double* q2) {
  // The limits form a box: what lies between two points inside it is inside as well.
  return legal(q1) && robot().withinLimits(q2) && allFree(samplesOf(q1, q2));
}

double SampledContext::freeFraction(const double* q1, const double* q2, const Grasp* held) {
  constexpr double kNothing = -1.0;
  requireFinite(q1);
  requireFinite(q2);
  hold(held);
  if (!legal(q1)) return kNothing;
  const EdgeSamples samples = samplesOf(q1, q2);
  std::int64_t free = firstBlocked(samples, lastWithinLimits(samples)) - 1;
  if (free < 0) return kNothing;
  if (free == samples.last()) return 1.0;
  // The part up to sample k is checked at samples 0 .. k again, except for rounding. Rounding can turn a
  // verdict that hangs by a hair, so that the promise about this part is verified where it does.
  const bool certain = beyondRounding();
  for (; free > 0; --free) {
    const double t = static_cast<double>(free) / static_cast<double>(samples.last());
    for (std::size_t i = 0; i < q_.size(); ++i) q_[i] = q1[i] + t * (q2[i] - q1[i]);
    if (certain ? robot().withinLimits(q_.data()) : isLegalEdgeFree(q1, q_.data())) return t;
  }
  return 0.0;
}

std::string SampledContext::describeCollision(const double* q, const Grasp* held) {
  requireFinite(q);
  hold(held);
  for (int i = 0; i < robot().dof(); ++i) {
    const auto joint = static_cast<std::size_t>(robot().plannedJoints()[static_cast<std::size_t>(i)]);
    if (q[i] < robot().lower()[i] || q[i] > robot().upper()[i])
      return robot().model().joints[joint].name + ", joint limits";
  }
  const auto names = [this](const PiecePair& pair) {
    return pieces_.world().pieces()[pair.a].owner + ", " + pieces_.world().pieces()[pair.b].owner;
  };
  if (const PiecePair* pair = pieces_.rigidCollision()) return names(*pair);
  pieces_.place(q);
  for (const PiecePair& pair : pieces_.pairs())
    if (pieces_.overlap(pair)) return names(pair);
  return {};
}

void SampledContext::requireFinite(const double* q) const {
  for (int i = 0; i < robot().dof(); ++i)
    if (!std::isfinite(q[i]))
      throw std::invalid_argument("joint value " + std::to_string(i) + " is not finite");
}

EdgeSamples SampledContext::samplesOf(const double* q1, const double* q2) {
  return {q1, q2, robot().dof(), pieces_.sweptBound(q1, q2), pieces_.world().problem().edge_step_m};
}

// Largest k such that samples 0 .. k keep the joint limits, which the first one does.
std::int64_t SampledContext::lastWithinLimits(const EdgeSamples& samples) {
  if (robot().withinLimits(samples.q2())) return samples.last();
  std::int64_t inside = 0, outside = samples.last();
  while (outside - inside > 1) {
    const std::int64_t middle = inside + (outside - inside) / 2;
    samples.at(middle, q_.data());
    (robot().withinLimits(q_.data()) ? inside : outside) = middle;
  }
  return inside;
}

}  // namespace b4p
