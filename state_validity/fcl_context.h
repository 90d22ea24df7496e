// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "state_validity/edge_search.h"
#include "state_validity/sampled_context.h"

namespace b4p {

/// One thread's access to an FclWorld.
class FclContext : public SampledContext {
 public:
  explicit FclContext(std::shared_ptr<const FclWorld> world);

  std::uint64_t configurationsChecked() const override { return statesAsked() + search_.checked(); }

 private:
  bool stateFree(const double* q) override;
  bool allFree(const EdgeSamples& samples) override { return search_.allFree(samples); }
  std::int64_t firstBlocked(const EdgeSamples& samples, std::int64_t last) override {
    return search_.firstBlocked(samples, last);
  }

  EdgeSearch search_;
  std::size_t last_hit_ =
      0;  ///< pair that collided last; looked at first, since neighbours tend to collide alike
};

}  // namespace b4p
