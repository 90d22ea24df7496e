// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/vector_context.h"

#include <algorithm>
#include <utility>

namespace b4p {

VectorContext::VectorContext(std::shared_ptr<const FclWorld> world,
                             std::shared_ptr<const lanes::LaneModel> model)
    : SampledContext(std::move(world)), search_(std::move(model), pieces()), far_search_(pieces()) {}

bool VectorContext::stateFree(const double* q) {
  if (search_.covers(q)) return search_.stateFree(q);
  const EdgeSamples state(q, q, robot().dof(), 0.0, 1.0);
  return far_search_.allFree(state);
}

bool VectorContext::allFree(const EdgeSamples& samples) {
  return covers(samples) ? search_.allFree(samples) : far_search_.allFree(samples);
}

std::int64_t VectorContext::firstBlocked(const EdgeSamples& samples, std::int64_t last) {
  within_range_ = covers(samples);
  return within_range_ ? search_.firstBlocked(samples, last) : far_search_.firstBlocked(samples, last);
}

void VectorContext::areFree(const double* q, int count, const Grasp* held, bool* free) {
  const int dof = robot().dof();
  bool usual = true;
  for (int i = 0; i < count; ++i) {
    requireFinite(q + i * dof);
    usual = usual && search_.covers(q + i * dof);
  }
  hold(held);
  if (pieces().rigidCollision()) {
    std::fill(free, free + count, false);
  } else if (usual) {
    search_.statesFree(q, count, free);
    for (int i = 0; i < count; ++i) free[i] = free[i] && robot().withinLimits(q + i * dof);
  } else {
    SampledContext::areFree(q, count, held, free);
  }
}

}  // namespace b4p
