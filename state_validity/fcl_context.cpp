// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/fcl_context.h"

#include <utility>

namespace b4p {

FclContext::FclContext(std::shared_ptr<const FclWorld> world)
    : SampledContext(std::move(world)), search_(pieces()) {}

bool FclContext::stateFree(const double* q) {
  pieces().place(q);
  const std::vector<PiecePair>& pairs = pieces().pairs();
  if (last_hit_ < pairs.size() && pieces().collide(pairs[last_hit_])) return false;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!pieces().collide(pairs[i])) continue;
    last_hit_ = i;
    return false;
  }
  return true;
}

}  // namespace b4p
