// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "state_validity/edge_search.h"
#include "state_validity/lanes/lane_search.h"
#include "state_validity/sampled_context.h"

namespace b4p {

/// One thread's access to a world through blocks of configurations.
class VectorContext : public SampledContext {
 public:
  VectorContext(std::shared_ptr<const FclWorld> world, std::shared_ptr<const lanes::LaneModel> model);

  void areFree(const double* q, int count, const Grasp* held, bool* free) override;
  std::uint64_t configurationsChecked() const override { return search_.checked() + far_search_.checked(); }

  /// How many times FCL has been asked about a pair of bodies.
  std::uint64_t pairsJudged() const { return search_.judged(); }

 private:
  bool stateFree(const double* q) override;
  bool allFree(const EdgeSamples& samples) override;
  std::int64_t firstBlocked(const EdgeSamples& samples, std::int64_t last) override;
  bool beyondRounding() const override { return within_range_ && search_.beyondRounding(); }
  bool covers(const EdgeSamples& samples) const {
    return search_.covers(samples.q1()) && search_.covers(samples.q2());
  }

  lanes::LaneSearch search_;
  bool within_range_ = true;  ///< of the last edge
  EdgeSearch far_search_;     ///< for joint values out of the range of single precision
};

}  // namespace b4p
