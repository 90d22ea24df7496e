// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/fcl_context.h"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace b4p {
namespace {

void requireFinite(const double* q, int dof) {
  for (int i = 0; i < dof; ++i)
    if (!std::isfinite(q[i]))
      throw std::invalid_argument("joint value " + std::to_string(i) + " is not finite");
}

}  // namespace

FclContext::FclContext(std::shared_ptr<const FclWorld> world)
    : pieces_(std::move(world)), search_(pieces_), q_(static_cast<std::size_t>(robot().dof())) {}

bool FclContext::isFree(const double* q, const Grasp* held) {
  requireFinite(q, robot().dof());
  ++states_checked_;
  pieces_.hold(held);
  if (pieces_.rigidCollision() || !robot().withinLimits(q)) return false;
  pieces_.place(q);
  const std::vector<PiecePair>& pairs = pieces_.pairs();
  if (last_hit_ < pairs.size() && pieces_.collide(pairs[last_hit_])) return false;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!pieces_.collide(pairs[i])) continue;
    last_hit_ = i;
    return false;
  }
  return true;
}

bool FclContext::isEdgeFree(const double* q1, const double* q2, const Grasp* held) {
  requireFinite(q1, robot().dof());
  requireFinite(q2, robot().dof());
  pieces_.hold(held);
  return isLegalEdgeFree(q1, q2);
}

bool FclContext::isLegalEdgeFree(const double* q1, const double* q2) {
  // The limits form a box: what lies between two points inside it is inside as well.
  if (pieces_.rigidCollision() || !robot().withinLimits(q1) || !robot().withinLimits(q2)) return false;
  return search_.allFree(samplesOf(q1, q2));
}

double FclContext::freeFraction(const double* q1, const double* q2, const Grasp* held) {
  constexpr double kNothing = -1.0;
  requireFinite(q1, robot().dof());
  requireFinite(q2, robot().dof());
  pieces_.hold(held);
  if (pieces_.rigidCollision() || !robot().withinLimits(q1)) return kNothing;
  const EdgeSamples samples = samplesOf(q1, q2);
  std::int64_t free = search_.firstBlocked(samples, lastWithinLimits(samples)) - 1;
  if (free < 0) return kNothing;
  if (free == samples.last()) return 1.0;
  // The part up to sample k is checked at samples 0 .. k again, except for rounding. Rounding can turn a
  // verdict that hangs by a hair, so that the promise about this part is verified rather than believed.
  for (; free > 0; --free) {
    const double t = static_cast<double>(free) / static_cast<double>(samples.last());
    for (std::size_t i = 0; i < q_.size(); ++i) q_[i] = q1[i] + t * (q2[i] - q1[i]);
    if (isLegalEdgeFree(q1, q_.data())) return t;
  }
  return 0.0;
}

std::string FclContext::describeCollision(const double* q, const Grasp* held) {
  requireFinite(q, robot().dof());
  pieces_.hold(held);
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

EdgeSamples FclContext::samplesOf(const double* q1, const double* q2) const {
  return {q1, q2, robot().dof(), search_.sweptBound(q1, q2), pieces_.world().problem().edge_step_m};
}

// Largest k such that samples 0 .. k keep the joint limits, which the first one does.
std::int64_t FclContext::lastWithinLimits(const EdgeSamples& samples) {
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
