// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "state_validity/edge_samples.h"
#include "state_validity/lanes/lane_block.h"
#include "state_validity/lanes/lane_model.h"
#include "state_validity/posed_pieces.h"

namespace b4p::lanes {

/// Checks states and the samples of edges many at a time; the answers are those of checking each through FCL.
///
/// A block of samples is spread over a stretch of an edge. A pair of bodies that is farther apart at a sample
/// than it can close on the way to the ends of the sample's own part is free on all of that part; where a
/// part has pairs left, a finer block follows for these. Bounds of distances in single precision decide, and
/// FCL where these cannot tell. One object per thread; reuses its memory.
class LaneSearch {
 public:
  LaneSearch(std::shared_ptr<const LaneModel> model, PosedPieces& pieces);

  /// False where joint values are out of the range of single precision; ask another search then.
  bool covers(const double* q) const { return model_->covers(q); }

  /// All three for what `pieces` holds.
  bool stateFree(const double* q);
  bool allFree(const EdgeSamples& samples);
  std::int64_t firstBlocked(const EdgeSamples& samples, std::int64_t last);

  /// For each of `count` configurations, dof values each, whether nothing collides.
  void statesFree(const double* q, int count, bool* free);

  /// Whether bounds alone, with their margins, have shown free what the last firstBlocked() calls free.
  bool beyondRounding() const { return !asked_fcl_; }

  /// Configurations looked at so far: lanes in use.
  std::uint64_t checked() const { return checked_; }

  /// How many times FCL has been asked about a pair of bodies.
  std::uint64_t judged() const { return judged_; }

 private:
  // One sample, and the samples first .. last that it answers for.
  struct Part {
    std::int64_t k = 0;
    std::int64_t first = 0;
    std::int64_t last = 0;
  };
  // Parts in the order of the edge, to be checked for the pairs near_[begin .. end).
  struct Parts {
    Part part[kLanes];
    int parent[kLanes] = {};  ///< lane of the coarser block
    int used = 0;
    std::size_t begin = 0;
    std::size_t end = 0;
  };
  struct Hands {
    std::uint64_t serial = 0;
    LaneRobot robot;
    std::vector<float> pair_travel_m;  ///< [joint][pair]: how much closer the pair comes per unit of the
                                       ///< joint; empty until edges ask
  };

  const Hands& hands();
  void boundPairTravel(Hands& in_hand);
  void start(const EdgeSamples& samples, const LaneRobot& robot);
  void run(const EdgeSamples& samples, const LaneRobot& robot, const Parts& parts, bool all_pairs, bool any);
  bool judge(const EdgeSamples& samples, const Parts& parts, std::uint32_t lane_bits, int& blocked_lane);
  void addFiner(const Parts& parts, std::int64_t end, bool nearest_last);
  static void splitEvenly(std::int64_t last, Parts& into);
  static void splitFinerAtFront(std::int64_t last, Parts& into);

  std::shared_ptr<const LaneModel> model_;
  PosedPieces& pieces_;
  int dof_;
  std::vector<std::unique_ptr<Hands>> known_;
  BlockQuery query_;
  BlockScratch scratch_;
  std::vector<float> q_lanes_;
  std::vector<double> q_;
  std::vector<float> body_motion_m_;
  std::vector<float> pair_motion_m_;
  std::vector<Parts> parts_;
  std::vector<Parts> finer_;
  std::vector<PairLanes> near_;
  std::uint64_t checked_ = 0;
  std::uint64_t judged_ = 0;
  bool asked_fcl_ = false;
};

}  // namespace b4p::lanes
